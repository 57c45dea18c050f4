// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// Fills in what the motion's origins say is derived, and marks it so.
///
/// Velocities are the slopes, at each sample's own time, of the parabola that fits the sample and
/// `reach` neighbours on either side by least squares, so with one through all three; at the ends
/// of a stretch between breaks, of its first or last 2 reach + 1. Accelerations are the slopes of
/// the velocities where those are given, and the curvature of the same parabola where they are not.
/// Rotations of a spatial base count as rotation vectors from the sample's own. Second order in the
/// step, on uneven steps too; a stretch of two samples has one slope and no curvature, a single
/// sample neither. Throws io::SpecError where the whole motion has too few for what is missing.
/// docs/derivations/whole_body_check.md eq. (1).
void derive_rates(const dynamics::Tree& tree, Motion& motion, Eigen::Index reach = 1);

/// Returns a table of rows over time, such as forces, averaged over samples as derived
/// accelerations are: what derive_rates() makes of its integral, or of the integral's integral.
Eigen::MatrixXd spread_as_accelerations(const Motion& motion, const Eigen::MatrixXd& table);

/// Whether velocities are given, so that accelerations are their slopes.
bool has_given_velocity(const Motion& motion);

/// The acceleration of a sample as derive_rates() has it, where it may look at all samples, and the
/// factor by which it amplifies the noise of what is differentiated. Requires `reach` samples on
/// either side.
struct FittedAcceleration {
  Eigen::VectorXd acceleration;
  double gain = 0.0;
};
FittedAcceleration fitted_acceleration(const dynamics::Tree& tree, const Motion& motion,
                                       Eigen::Index sample, Eigen::Index reach);

/// Factors by which derived accelerations amplify errors of what is differentiated.
struct Amplification {
  Eigen::VectorXd noise;  ///< (samples x 1): of independent ones, by their standard deviation.
  Eigen::VectorXd most;   ///< Of any, by their greatest size.
};
/// Returns what they do where rates look at `reach` neighbours on either side; 0 in stretches too
/// short for an acceleration. Steps of time count as even within a stretch.
Amplification amplification(const Motion& motion, Eigen::Index reach);

/// Returns the displacement along the velocities from one position to another: exact for a step at
/// constant velocity (dynamics::step_position()).
Eigen::VectorXd displacement(const dynamics::Tree& tree, const Eigen::VectorXd& from,
                             const Eigen::VectorXd& to);

}  // namespace torquewright::hopper
