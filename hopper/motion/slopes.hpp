// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// Fills in what the motion's origins say is derived, and marks it so.
///
/// Velocities are the slopes, at each sample's own time, of the parabola through the sample and its
/// two neighbours; at the ends of a stretch between breaks, through its first or last three.
/// Accelerations are the slopes of the velocities where those are given, and the curvature of the
/// same parabola where they are not. Rotations of a spatial base count as rotation vectors from the
/// sample's own. Second order in the step, on uneven steps too; a stretch of two samples has one
/// slope and no curvature, a single sample neither. docs/derivations/whole_body_check.md eq. (1).
void derive_rates(const dynamics::Tree& tree, Motion& motion);

/// From one position to another as a displacement along the velocities: exact for a step at
/// constant velocity (dynamics::step_position()).
Eigen::VectorXd displacement(const dynamics::Tree& tree, const Eigen::VectorXd& from,
                             const Eigen::VectorXd& to);

}  // namespace torquewright::hopper
