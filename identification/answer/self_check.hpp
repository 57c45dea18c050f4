// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {

/// Whether refined actuators, as their own documents say them, leave what was promised of them: the
/// logs are read and their errors taken once more. Empty if they do, else a sentence with equation,
/// promise and what came out. `refined`: of every joint.
std::string broken_promise(const std::vector<std::filesystem::path>& logs, const Rig& rig,
                           const std::vector<JointActuator>& refined, const Identification& found);

}  // namespace torquewright::identification
