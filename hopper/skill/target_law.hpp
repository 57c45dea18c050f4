// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Gains of the joints that drives move (joints x 1, of the bodies after the base; zero elsewhere).
struct TargetGains {
  Eigen::VectorXd stiffness_Nm_rad;
  Eigen::VectorXd damping_Nm_s_rad;
};

/// Torques that draw joints to their targets: stiffness (target - position) - damping speed at each
/// joint (seed 000, A.3), through the mechanisms to their drives. The robot must outlive it.
class TargetLaw {
 public:
  /// Requires gains of this robot.
  TargetLaw(const Robot& robot, TargetGains gains);

  /// Writes the torques at the drives' outputs (drives x 1). A mechanism that does not reach the
  /// joints as they are seen asks for nothing.
  void torque(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity,
              const Eigen::VectorXd& target_rad, Eigen::VectorXd& drive_Nm) const;

 private:
  const Robot& robot_;
  TargetGains gains_;
  Eigen::Index drives_ = 0;
};

}  // namespace torquewright::hopper
