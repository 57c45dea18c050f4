// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/model/robot.hpp"
#include "robot/urdf/urdf_writer.hpp"

namespace torquewright::hopper {

/// Who reads the SDFormat.
enum class SdfReader {
  kGazebo,  ///< Dry friction of joints; no field for armatures.
  kDrake,   ///< Armatures as drake: elements, and the actuated joints; no dry friction of joints.
};

/// Writes the robot as SDFormat 1.9: links, joints with limits, dampers, dry friction and springs.
Exported sdf_of(const Robot& robot, SdfReader reader, const DrivesInJoints& drives = {});

}  // namespace torquewright::hopper
