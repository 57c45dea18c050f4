// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/smoothed_window.hpp"

namespace torquewright::hopper {

/// The window for motions whose positions (or velocities) are rounded to steps or noisy at a rate
/// that a few samples do not average out: of all that double from one neighbour on, the one whose
/// accelerations are known best by nineteen of twenty samples, in the coordinate that is known
/// worst (rad and m weigh alike). How well is the sum of
///
/// - what steps and noise may make of it: half a step times the sum of the weights' sizes, which
///   rounding never exceeds, and four standard deviations of the noise beside;
/// - what changes where it looks twice as far, which holds what smoothing takes away;
/// - what a narrower window shows that this one hides, beyond what both may make of steps and
///   noise: as far as the window one narrower still leaves open.
///
/// docs/derivations/whole_body_check.md, "Steps". `noise` (n x 1) is what
/// noise_of_differentiated() finds; motion.steps are known. Requires seven samples.
Smoothing smoothing_of_least_doubt(const dynamics::Tree& tree, const Motion& motion,
                                   const Eigen::VectorXd& noise);

}  // namespace torquewright::hopper
