// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include "hopper/robot/robot.hpp"

namespace torquewright::hopper {

/// A keyframe of each of the robot's postures, and "home": joints as near to zero as their ranges
/// allow. The base is upright, and so high that the lowest contact point touches the ground.
void write_keyframes(tinyxml2::XMLPrinter& out, const Robot& robot);

}  // namespace torquewright::hopper
