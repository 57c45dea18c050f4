// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace torquewright::hopper {

/// A task of specs/training_task, as the build put it into the program.
struct EmbeddedTask {
  std::string_view name;
  std::string_view text;
};

std::span<const EmbeddedTask> embedded_tasks();

}  // namespace torquewright::hopper
