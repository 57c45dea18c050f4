// SPDX-License-Identifier: Apache-2.0
#include "hopper/skill/target_law.hpp"

#include <utility>

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::VectorXd;

TargetLaw::TargetLaw(const Robot& robot, TargetGains gains)
    : robot_(robot), gains_(std::move(gains)) {
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    drives_ += static_cast<Index>(drivetrain.actuators.size());
  }
}

void TargetLaw::torque(const VectorXd& position, const VectorXd& velocity,
                       const VectorXd& target_rad, VectorXd& drive_Nm) const {
  drive_Nm.setZero(drives_);
  const Index joints = target_rad.size();
  Index first = 0;
  for (const Drivetrain& drivetrain : robot_.drivetrains) {
    const auto size = static_cast<Index>(drivetrain.joints.size());
    SmallVector joint_rad(size), joint_rad_s(size), joint_Nm(size);
    for (Index i = 0; i < size; ++i) {
      const auto joint = static_cast<Index>(drivetrain.joints[static_cast<std::size_t>(i)]) - 1;
      joint_rad[i] = position.tail(joints)[joint];
      joint_rad_s[i] = velocity.tail(joints)[joint];
      joint_Nm[i] = gains_.stiffness_Nm_rad[joint] * (target_rad[joint] - joint_rad[i]) -
                    gains_.damping_Nm_s_rad[joint] * joint_rad_s[i];
    }
    const auto transfer = drivetrain.mechanism->transfer(joint_rad, joint_rad_s);
    if (transfer) drive_Nm.segment(first, size) = actuator_torque_Nm(*transfer, joint_Nm);
    first += size;
  }
}

}  // namespace torquewright::hopper
