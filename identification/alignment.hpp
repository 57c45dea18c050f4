// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "identification/acceptance.hpp"

namespace torquewright::identification {

/// One channel is late against the others.
struct Delay {
  Quantity channel = Quantity::kOutputTorque;
  double delay_s = 0.0;  ///< Positive: late.
  double error_s = 0.0;
  Gain gain;  ///< Over no delay, with everything smooth refitted.
};

/// The delay between the two sides of the torque balance at which a rich smooth model (friction,
/// inertia, torque constant, gravity, offset, all refitted) leaves least where it was not fitted.
/// Empty if it cannot be told from none, or the minimum lies at the range's end.
/// docs/derivations/identification.md section 3.
std::optional<Delay> find_delay(const Bench& bench, const std::vector<Signals>& signals,
                                const std::vector<std::size_t>& fold_of_run);

}  // namespace torquewright::identification
