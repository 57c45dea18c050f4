// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "identification/recordings/joint_state.hpp"

namespace torquewright::identification {

/// Whether a type's name is that of joint states, in ROS 2's spelling, ROS 1's, or without a
/// package.
bool is_joint_state(std::string_view type);

/// Reads a message as its encoding says ("cdr" or "json"). Returns what is wrong, as the end of a
/// sentence that begins with "a message"; empty where nothing is.
std::string read_joint_state(std::string_view encoding, std::string_view bytes, JointState& state);

}  // namespace torquewright::identification
