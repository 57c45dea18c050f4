// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// How far derived accelerations look to either side, and the noise that they then hold.
struct Smoothing {
  Eigen::Index reach = 1;  ///< Samples to either side.
  /// Standard deviation of derived accelerations, by coordinate; empty: unknown.
  Eigen::VectorXd acceleration_noise;
  /// Motion::acceleration_doubt; empty where the rule of smoothing_of() decides.
  Eigen::MatrixXd acceleration_doubt = {};
};

}  // namespace torquewright::hopper
