// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/xml/element.hpp"

namespace torquewright::hopper {

/// What a URDF's <gazebo> elements tell their own simulator and no robot document holds: what moves
/// the robot otherwise there by its name, consequence and places, the rest in one sentence.
std::vector<std::string> gazebo_notes(const Element& robot);

}  // namespace torquewright::hopper
