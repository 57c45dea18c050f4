// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/signals/bench.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Current of a motor's winding at each sample, from the drive's channel.
struct Currents {
  std::vector<double> current_A;
  /// Derivative of the current by the drive's channel, in A/V or A/A.
  std::vector<double> per_unit;
};

/// Computes the current of a quasi-static winding with dead time, the resistance at its
/// temperature, and the bus's sag where the bus was not logged. `voltage_V` and `at` belong to the
/// samples of `signals`; the voltage was moved forward by `late_s`. Dead time acts on the voltage
/// before the low-pass, whose fast part the signals hold (docs/derivations/identification.md
/// section 12).
Currents winding_currents(const Bench& bench, const actuator::Actuator& actuator,
                          const Signals& signals, const std::vector<double>& voltage_V,
                          const std::vector<actuator::Instant>& at, double late_s);

}  // namespace torquewright::identification
