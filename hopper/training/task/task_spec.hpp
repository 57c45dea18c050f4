// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hopper/training/task/task.hpp"
#include "io/documents/document.hpp"

namespace torquewright::hopper {

/// Names of the tasks that come with the program.
std::vector<std::string> training_task_names();

/// Reads the task of that name, or a file of kind `training_task`. Throws io::SpecError with all
/// its faults: what the schema refuses, terms that there are none of (with the nearest).
Task read_task(const std::string& name_or_file);

/// The same of a text, as a policy carries it in `file`.
Task task_of(const std::string& text, const std::string& file);

/// The task with a flight from and until these times since the begin; what comes behind its landing
/// lasts as long as it did. Throws io::SpecError where the task states no landing.
Task with_flight(const Task& task, double from_s, double until_s);

}  // namespace torquewright::hopper
