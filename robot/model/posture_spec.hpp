// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "io/faults/spec_error.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper {

/// Reads `postures` of a checked robot document into a robot whose tree is built. Faults: joints
/// that are unknown (with the nearest name), positions outside a joint's range.
void read_postures(const io::Document& document, Robot& robot, std::vector<io::Fault>& faults);

}  // namespace torquewright::hopper
