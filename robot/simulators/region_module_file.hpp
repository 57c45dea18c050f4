// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/simulators/region_module.hpp"
#include "robot/urdf/urdf_writer.hpp"

namespace torquewright::hopper {

/// Null where that format is none.
const RegionModule* find_region_module(std::string_view format);
std::vector<std::string_view> region_module_formats();

/// The module: each drive's region once, GROUPS of joints and what their drives turn and carry at
/// the posture nearest to zero, JOINTS with armature, friction, springs and gains (kp = I w^2, kv =
/// 2 z I w of the joint's armature, as `actuator mor --format mujoco` has them), and the
/// simulator's own functions. Throws io::SpecError where a drive has no region or the robot has no
/// drives.
Exported region_module_of(const Robot& robot, const RegionModule& module,
                          const std::vector<std::string>& origin, actuator::FrictionPlace friction);

}  // namespace torquewright::hopper
