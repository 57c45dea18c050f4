// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A keyframe of each of the robot's postures, and "home": joints as near to zero as their ranges
/// allow. With `only_zero` those whose joints are not all at zero are left out. The base is
/// upright, and so high that the lowest contact point touches the ground.
void write_keyframes(tinyxml2::XMLPrinter& out, const Robot& robot, bool only_zero);

}  // namespace torquewright::hopper
