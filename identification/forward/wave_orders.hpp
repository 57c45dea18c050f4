// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/signals/bench.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Orders of waves (periods per turn), by the angle that they turn with.
struct WaveOrders {
  std::vector<double> motor;     ///< Orders of cogging, over the motor's angle.
  std::vector<double> output;    ///< Orders of ripple that adds, over the output's angle.
  std::vector<double> load;      ///< Orders of ripple in proportion to the load.
  std::vector<double> friction;  ///< Orders of waves of the Coulomb friction.
};

/// Returns the orders that are worth a candidate: peaks of the spectrum over angle of what a smooth
/// model leaves of `left` in the runs that may be fitted. An order needs one of its periods within
/// the range of the angle. The search decides whether it earns a place
/// (docs/derivations/identification.md section 6).
WaveOrders promising_waves(const Bench& bench, const OfStretch& left,
                           const std::vector<Signals>& signals,
                           const std::vector<std::size_t>& fold_of_run,
                           const actuator::Ranges& ranges);

}  // namespace torquewright::identification
