// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A drive as `actuator mor --format mujoco` writes its region, and how it turns with joints.
struct Drive {
  std::string name;
  double stall_torque_Nm = 0;
  double no_load_speed_rad_s = 0;
  double greatest_torque_Nm = 0;
  double bus_V = 0;
  bool is_curve = false;  ///< Known by its curve alone: its control is a torque.
  std::vector<std::size_t> joints;
  std::vector<double> ratios;  ///< Its speed over each joint's.
};

/// Every drive of the robot; ratios are those of the posture nearest to zero, and a note says where
/// they change. Throws io::SpecError where a drive has no region.
std::vector<Drive> drives_of(const Robot& robot, std::vector<std::string>& notes);

/// <tendon> and <actuator>: drives, whose control is the voltage in V, or
/// the torque in Nm of those that are known by their curve, by a joint or by a tendon of
/// several; motors of all joints that have a torque limit.
void write_drives(tinyxml2::XMLPrinter& out, const Robot& robot, const std::vector<Drive>& drives);

}  // namespace torquewright::hopper
