// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {

/// Returns what the logs say of refined actuators as their own documents state them: their errors
/// without a search, on the runs and in the bands of what was found, as `identify residual` has
/// them. What the documents hold is not open any more, values of the load are. `refined` holds the
/// documents of all joints.
Identification as_written(const std::vector<std::filesystem::path>& logs, Rig rig,
                          const std::vector<JointActuator>& refined, const Identification& found);

/// Checks that they leave the errors that were promised. Empty if they do, else a sentence with
/// equation, promise and result.
std::string broken_promise(const Identification& found, const Identification& judged);

}  // namespace torquewright::identification
