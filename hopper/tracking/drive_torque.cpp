// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/drive_torque.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace torquewright::hopper {

Eigen::VectorXd peak_torques_Nm(const Robot& robot) {
  std::vector<double> peaks_Nm;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& one : drivetrain.actuators) {
      const double electric_Nm = one.motor.torque_constant_Nm_A * one.drive.peak_current_A *
                                 std::abs(one.transmission.ratio) *
                                 one.transmission.forward_efficiency;
      peaks_Nm.push_back(std::min(electric_Nm, one.transmission.peak_torque_Nm));
    }
  }
  return Eigen::Map<Eigen::VectorXd>(peaks_Nm.data(), static_cast<Eigen::Index>(peaks_Nm.size()));
}

}  // namespace torquewright::hopper
