// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/lint/check.hpp"

namespace torquewright::actuator::lint {

/// Torque eta N Kt I at the side of a number of the data sheet, I in amperes of the torque constant
/// over `current_factor`.
RoundedInterval sheet_torque(const Interpretation& interpretation, const RoundedInterval& current_A,
                             const char* name);

/// Returns a current with or without the stated no-load current taken off: some makers subtract
/// what the drag needs.
RoundedInterval less_drag(const Interpretation& interpretation, RoundedInterval current_A);

/// Returns the share that losses or saturation would have to take, where less is stated than
/// follows.
std::vector<Explanation> losses(const Actuator& document, const RoundedInterval& stated,
                                const RoundedInterval& expected);
constexpr double kGreatestLoss_percent = 30.0;  ///< Above it this explains nothing.

}  // namespace torquewright::actuator::lint
