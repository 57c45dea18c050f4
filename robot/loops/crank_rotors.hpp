// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Sentences about drives of mechanisms whose rotors a file states (a crank's armature) otherwise
/// than their actuators' documents do, by more than a twentieth.
std::vector<std::string> rotors_that_differ(const Robot& robot);

}  // namespace torquewright::hopper
