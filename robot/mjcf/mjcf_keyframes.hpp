// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A keyframe of each of the robot's postures, and "home": joints as near to zero as their ranges
/// allow. Where there are `references`, as LoopedRobot has them, only postures with all joints
/// there are held. The base is upright, and so high that the lowest contact point touches the
/// ground.
void write_keyframes(tinyxml2::XMLPrinter& out, const Robot& robot,
                     const std::vector<double>& references);

}  // namespace torquewright::hopper
