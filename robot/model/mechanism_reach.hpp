// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "io/faults/spec_error.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Adds a fault at the place where the mechanism does not reach, or is singular at, the posture
/// nearest to zero that the joints' ranges allow, or there the end of one joint's range. Both ends
/// together, which no range promises, are not asked for.
void reach_faults(const dynamics::Tree& tree, const Drivetrain& drivetrain, const io::Fault& place,
                  std::vector<io::Fault>& faults);

/// The posture nearest to zero that the joints' ranges allow.
SmallVector home_posture_rad(const dynamics::Tree& tree, const std::vector<std::size_t>& joints);

}  // namespace torquewright::hopper
