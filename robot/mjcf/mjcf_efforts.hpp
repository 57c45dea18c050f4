// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/mjcf/mjcf_context.hpp"

namespace torquewright::hopper {

/// What actuators can do at joints.
struct MjcfEfforts {
  /// The greatest effort that all actuators of a joint can make together, where each has a limit:
  /// gear times its force range or, of a plain motor, times its control range.
  std::map<std::string, double> limit;
  std::vector<std::string> notes;
};

/// The actuator of each joint that one drives, by the joint; its own name, or "".
std::map<std::string, std::string> driven_joints(const Element& mujoco, const MjcfContext& context);

MjcfEfforts read_efforts(const Element& mujoco, const MjcfContext& context);

}  // namespace torquewright::hopper
