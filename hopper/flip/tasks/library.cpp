// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/tasks/library.hpp"

#include <stdexcept>

namespace torquewright::hopper {

const std::vector<const PlanTask*>& every_task() {
#define TORQUEWRIGHT_LIST(name) &tasks::name,
  static const std::vector<const PlanTask*> all{TORQUEWRIGHT_EVERY_TASK(TORQUEWRIGHT_LIST)};
#undef TORQUEWRIGHT_LIST
  return all;
}

std::vector<std::string> task_names() {
  std::vector<std::string> names;
  for (const PlanTask* task : every_task()) names.emplace_back(task->name);
  return names;
}

const PlanTask& task_named(std::string_view name) {
  for (const PlanTask* task : every_task()) {
    if (task->name == name) return *task;
  }
  throw std::invalid_argument("no task is named \"" + std::string(name) + "\"");
}

}  // namespace torquewright::hopper
