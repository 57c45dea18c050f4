// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/flip/tasks/every_task.hpp"

namespace torquewright::hopper {

/// In the order in which help and messages list them.
const std::vector<const PlanTask*>& every_task();
std::vector<std::string> task_names();

/// std::invalid_argument where none has that name: options allow no other word.
const PlanTask& task_named(std::string_view name);

}  // namespace torquewright::hopper
