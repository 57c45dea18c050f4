// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "identification/recordings/joint_state.hpp"

namespace torquewright::identification {

/// Reads a message that is a JSON object with the names of the type's fields; what is missing is
/// empty. Returns what is wrong as read_joint_state does.
std::string read_json_joint_state(std::string_view bytes, JointState& state);

}  // namespace torquewright::identification
