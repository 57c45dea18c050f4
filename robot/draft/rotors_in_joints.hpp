// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// The tree as formats without mechanisms can hold it. Rotors that turn with several joints, or at
/// a ratio that changes, stand in each joint with what they weigh there at the posture nearest to
/// zero: the diagonal of the reflected inertia. A note says what is lost.
dynamics::Tree tree_with_rotors(const Robot& robot, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
