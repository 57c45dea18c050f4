// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/planning/tasks/every_task.hpp"

namespace torquewright::hopper {

/// Returns all tasks, in the order in which help and messages list them.
const std::vector<const PlanTask*>& every_task();
std::vector<std::string> task_names();

/// Returns the task of that name. std::invalid_argument where there is none: options allow no other
/// word.
const PlanTask& task_named(std::string_view name);

}  // namespace torquewright::hopper
