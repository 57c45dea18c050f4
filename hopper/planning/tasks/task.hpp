// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hopper/planning/tasks/plan_goal.hpp"

namespace torquewright::hopper {

struct PlanOptions;

/// A task that a plan can be asked for. Each is one file in this folder and one line in
/// every_task.hpp.
struct PlanTask {
  std::string_view name;
  std::string_view sentence;  ///< Description for a user of what the robot does.
  /// Whether it takes `--rise`; `--stride`, `--speed` and `--land-at`; and `--repeat`.
  bool takes_rise = false;
  bool takes_stride = false;
  bool takes_repeat = false;
  /// Stances in order where nobody states them, for a foot with a sole. A foot of one point has
  /// flat, flight, flat.
  std::vector<std::string_view> stances_of_a_sole;
  /// Sets what it asks of a motion beside physics and standing at both ends.
  void (*set_goal)(const PlanOptions& options, PlanGoal& goal) = nullptr;
};

}  // namespace torquewright::hopper
