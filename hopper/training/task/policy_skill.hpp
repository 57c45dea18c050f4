// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/training/task/ready_task.hpp"

namespace torquewright::hopper {

/// The skill that a policy's document states: its inputs, outputs, gains and control period in the
/// place of the task's; the rest is the task's, gains of joints that it does not name among it.
/// io::SpecError, at `file`, where the robot has not what they name.
Skill skill_of(const ReadyTask& ready, const PolicyDocument& document, const std::string& file);

}  // namespace torquewright::hopper
