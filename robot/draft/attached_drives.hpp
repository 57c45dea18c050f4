// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A drive for all joints whose names are as a pattern says ("*" stands for any letters).
struct DrivePattern {
  std::string pattern;
  std::string file;  ///< Of the actuator, as the robot's document is to name it.
};

/// A joint and the file of the actuator that is to turn it.
struct AttachedDrive {
  std::string joint;
  std::string file;
  bool is_replaced = false;  ///< It had another drive.
};

/// Returns the joints that the patterns fit, in the robot's order. Throws io::SpecError where a
/// pattern fits no joint, two patterns fit one, or a linkage turns the joint.
std::vector<AttachedDrive> attached_drives(const Robot& robot,
                                           const std::vector<DrivePattern>& patterns);

}  // namespace torquewright::hopper
