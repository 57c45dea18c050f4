// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/signals/bench.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// WaveOrders of waves, by the angle that they turn with.
struct WaveOrders {
  std::vector<double> motor;     ///< Cogging.
  std::vector<double> output;    ///< Ripple that adds.
  std::vector<double> load;      ///< Ripple in proportion to the load.
  std::vector<double> friction;  ///< Of the Coulomb level.
};

/// WaveOrders that are worth a candidate: peaks of the spectrum over angle of what a smooth model
/// leaves of `left` in the runs that may be fitted. Whether they earn a place is for the search. An
/// order needs as much angle as one of its periods. docs/derivations/identification.md section 12.
WaveOrders promising_waves(const Bench& bench, const OfStretch& left,
                           const std::vector<Signals>& signals,
                           const std::vector<std::size_t>& fold_of_run,
                           const actuator::Ranges& ranges);

}  // namespace torquewright::identification
