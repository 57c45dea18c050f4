// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace torquewright::identification {

/// A message of the type sensor_msgs/msg/JointState.
struct JointState {
  std::int64_t stamp_ns = 0;  ///< When it was measured, by the clock of who sent it; 0: not said.
  std::vector<std::string> names;
  std::vector<double> position, velocity, effort;  ///< By name, or empty.
};

}  // namespace torquewright::identification
