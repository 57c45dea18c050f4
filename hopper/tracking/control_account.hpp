// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::hopper {

/// How far what a controller reached is from what it was to do, over a run.
struct TaskAccount {
  std::string task;  ///< Its kind and what it is of: "point heel_left".
  std::string unit;  ///< Of the residuals: "m/s^2".
  double rms = 0.0;  ///< Of the residual's size over all looks at which the task was active.
  double worst = 0.0;
  double worst_s = 0.0;  ///< When.
};

/// Of a controller that weighs tasks against each other; `tasks` is empty of others.
struct ControlAccount {
  std::vector<TaskAccount> tasks;
  long looks = 0;     ///< How often it was asked for torques,
  long unsolved = 0;  ///< and how often it had no answer but the motion's own.
};

}  // namespace torquewright::hopper
