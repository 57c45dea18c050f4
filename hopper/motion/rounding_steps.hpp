// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// Returns the greatest step of which all differences between the values are multiples, to a
/// twentieth of it; 0 where there is none.
double common_step(std::vector<double> values);

/// Returns the step to which the motion's positions are rounded, by coordinate (n x 1), in its
/// unit: an encoder's counts, or the digits of a text. 0 where there is none, or where it rounds
/// nothing: values that lie on steps because they move evenly. Of a quaternion, twice the greatest
/// of its elements' steps.
Eigen::VectorXd position_steps(const dynamics::Tree& tree, const Motion& motion);
/// Returns the same of its velocities.
Eigen::VectorXd velocity_steps(const Motion& motion);

/// Returns those of what accelerations are derived from: velocities where they are given, else
/// positions.
Eigen::VectorXd rounding_steps(const dynamics::Tree& tree, const Motion& motion);

}  // namespace torquewright::hopper
