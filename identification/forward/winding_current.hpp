// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/signals/bench.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// What a motor's winding carries at each sample, by the drive's channel.
struct Currents {
  std::vector<double> current_A;
  std::vector<double> per_unit;  ///< A/V or A/A: what a unit of the channel more would add.
};

/// Of a quasi-static winding with dead time, the resistance at its temperature, and the bus's sag
/// where the bus was not logged. `voltage_V` and `at`: of the samples of `signals`; `late_s`: by
/// which the voltage was moved forward. A dead time acts on the voltage before the low-pass, whose
/// fast part the signals hold. docs/derivations/identification.md section 12.
Currents winding_currents(const Bench& bench, const actuator::Actuator& actuator,
                          const Signals& signals, const std::vector<double>& voltage_V,
                          const std::vector<actuator::Instant>& at, double late_s);

}  // namespace torquewright::identification
