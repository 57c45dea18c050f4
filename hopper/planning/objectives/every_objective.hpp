// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/objectives/objective.hpp"

// One line for each objective; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_OBJECTIVE(objective)                                     \
  objective(effort) objective(energy) objective(gear_load) objective(region_margin) \
      objective(height) objective(time) objective(cam) objective(cav) objective(bav)

namespace torquewright::hopper::objectives {

#define TORQUEWRIGHT_DECLARE(name) extern const Objective name;
TORQUEWRIGHT_EVERY_OBJECTIVE(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::objectives
