// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/smoothed_window.hpp"

namespace torquewright::hopper {

/// Chooses the reach: one sample, unless the noise is more than a thousandth of the accelerations.
/// Then it doubles as long as the change stays within what noise explains: the widest window that
/// cannot be told from any narrower one (Lepski's rule; docs/derivations/whole_body_check.md,
/// "Noise"). Where what is differentiated is rounded to steps that may make more than that
/// thousandth of the accelerations (motion.steps, if known), or where the widest of these windows
/// does not average the noise out, smoothing_of_least_doubt() chooses.
Smoothing smoothing_of(const dynamics::Tree& tree, const Motion& motion);

/// Standard deviation of the noise of what is differentiated, by coordinate: the velocities where
/// they are given, else the positions. (n x 1); 0 where a log is too short to tell.
Eigen::VectorXd noise_of_differentiated(const dynamics::Tree& tree, const Motion& motion);

/// The same for any table of rows over the motion's time, where it is the noisiest: what nineteen
/// of twenty samples stay within, over 1.96.
Eigen::VectorXd sample_noise(const Motion& motion, const Eigen::MatrixXd& table);

}  // namespace torquewright::hopper
