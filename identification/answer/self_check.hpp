// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {

/// Checks that refined actuators, as their own documents state them, leave the errors that were
/// promised: the logs are read and their errors computed once more. Empty if they do, else a
/// sentence with equation, promise and result. `refined` holds the documents of all joints.
std::string broken_promise(const std::vector<std::filesystem::path>& logs, const Rig& rig,
                           const std::vector<JointActuator>& refined, const Identification& found);

}  // namespace torquewright::identification
