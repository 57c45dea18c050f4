// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "hopper/tracking/operational/tasks.hpp"
#include "io/documents/document.hpp"

namespace torquewright::hopper {

struct ReadTasks {
  OperationalTasks tasks;
  io::Document document;
};

/// Reads a document of kind `controller` for a robot. Throws io::SpecError with all faults: another
/// robot's name, joints and contacts that it does not have (with the nearest), a task that names
/// what it does not move or none of what it does, rigid joints without a spring.
ReadTasks read_tasks(const std::filesystem::path& file, const Robot& robot);
ReadTasks tasks_of(io::Document document, const Robot& robot);

}  // namespace torquewright::hopper
