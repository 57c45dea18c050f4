// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hopper/flip/plan_goal.hpp"

namespace torquewright::hopper {

struct PlanOptions;

/// What a plan can be asked for. One file each in this folder, one line in every_task.hpp.
struct PlanTask {
  std::string_view name;
  std::string_view sentence;  ///< What the robot does, for a person.
  /// Whether `--rise` and `--stride` mean something to it.
  bool takes_rise = false;
  bool takes_stride = false;
  /// What stands on the ground, in order, where nobody says: of a foot with a sole. A foot of one
  /// point has flat, flight, flat.
  std::vector<std::string_view> stances_of_a_sole;
  /// What it asks of a motion beside physics and standing at both ends.
  void (*set_goal)(const PlanOptions& options, PlanGoal& goal) = nullptr;
};

}  // namespace torquewright::hopper
