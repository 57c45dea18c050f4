// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/flip/tasks/task.hpp"

// One line for each task; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_TASK(task) task(flip) task(jump) task(hop)

namespace torquewright::hopper::tasks {

#define TORQUEWRIGHT_DECLARE(name) extern const PlanTask name;
TORQUEWRIGHT_EVERY_TASK(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::tasks
