// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hopper/tracking/reference.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Returns the torque of each drive at its output at the peak current, with the gears' loss and
/// limit and without saturation: a scale (drives x 1), in the order of the drivetrains.
Eigen::VectorXd peak_torques_Nm(const Robot& robot);

/// Gains of the loop about every drive. docs/derivations/tracking.md, "Drives of their own".
struct PdOptions {
  /// Error of the output for which a drive gives its peak torque; the stiffness is torque over
  /// error. Smaller: the feet tip before the body leans; greater: gravity bends the posture.
  double full_torque_error_rad = 0.5;
  /// Share of critical damping with the least inertia that the drive ever has, moved in the air.
  double damping_ratio = 1.0;
  /// Stiffness by drive, at its output, instead; empty: by the options above.
  Eigen::VectorXd stiffness_Nm_rad = {};
  Eigen::VectorXd damping_Nm_s_rad = {};  ///< Damping by drive, likewise.
};

struct PdGains {
  Eigen::VectorXd stiffness_Nm_rad;  ///< (drives x 1)
  Eigen::VectorXd damping_Nm_s_rad;
};

/// Computes the gains in the posture in which the reference begins. std::invalid_argument where
/// stated gains are not one per drive, or a mechanism does not reach that posture.
PdGains pd_gains(const Robot& robot, const Reference& reference, const PdOptions& options);

}  // namespace torquewright::hopper
