// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// Writes a motion as the CSV that read_motion() reads without mappings, with the same numbers to
/// the last bit: positions, the rates and torques that it was given (derived ones are derived
/// again), contact forces and flags where it has them. Two rows of one time are an impact. Times
/// count from the motion's origin. Throws std::invalid_argument for a number that is not finite.
std::string motion_csv(const Robot& robot, const Motion& motion);

}  // namespace torquewright::hopper
