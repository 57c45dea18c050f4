// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// A magnitude with the sign of what was asked for: it turns where the magnitude is least, within
/// `kLatestAnswer_s` of where what was asked for changes its sign and no nearer to another change.
/// Where nothing was asked for before the first change, the sign is that of the first. All of one
/// length; times ascend.
std::vector<double> with_signs(const std::vector<double>& time_s,
                               const std::vector<double>& magnitude,
                               const std::vector<double>& asked);

/// By how much later than what is asked for a drive's current may turn: a loop's lag and a
/// filter's.
constexpr double kLatestAnswer_s = 0.02;

/// Gives the columns that the rig calls without a sign that of their joint's commanded torque, and
/// says so. Throws io::SpecError where no torque was commanded, or a magnitude is below zero.
void give_signs(const Rig& rig, Log& log);

}  // namespace torquewright::identification
