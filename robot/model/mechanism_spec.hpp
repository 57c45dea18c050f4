// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "io/faults/spec_error.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper {

/// Reads the mechanisms of a robot's document, documents.front(), into the robot whose tree stands
/// already, and the actuators' documents after it. Direct ones give their joint the actuator's
/// reflected inertia where it states none.
void read_mechanisms(Robot& robot, std::vector<io::Document>& documents,
                     std::vector<io::Fault>& faults);

}  // namespace torquewright::hopper
