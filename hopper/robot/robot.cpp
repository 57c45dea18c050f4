// SPDX-License-Identifier: Apache-2.0
#include "hopper/robot/robot.hpp"

namespace torquewright::hopper {

std::optional<std::size_t> Robot::find_joint(const std::string& joint_name) const {
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    if (tree.bodies[i].joint.name == joint_name) return i;
  }
  return std::nullopt;
}

}  // namespace torquewright::hopper
