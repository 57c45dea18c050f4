// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "identification/findings/result.hpp"
#include "identification/log/log.hpp"
#include "identification/rollout/robot_model.hpp"
#include "identification/rollout/windows.hpp"

namespace torquewright::identification {

/// How far simulated joints are from measured ones: root mean square over all samples of all
/// windows.
struct RolloutError {
  double all_rad = 0.0;              ///< Over all joints.
  std::vector<double> by_joint_rad;  ///< In the rig's order.
  std::size_t windows = 0;           ///< Number of windows; 0: none, and no error is known.
  std::size_t diverged = 0;  ///< Of these, those left out whose simulation grew without bound.
};

/// Simulated less measured positions over one window, thinned to be drawn.
struct RolloutTrace {
  std::string run;
  bool is_held_out = false;
  std::vector<Curve> error_rad;  ///< By joint, in the rig's order.
};

/// Errors of windows of one length.
struct Rollout {
  double window_s = 0.0;
  RolloutError train, holdout;
  std::vector<RolloutTrace> traces;  ///< Where they were asked for.
};

/// Windows that are simulated, and what is kept of them.
struct RolloutPlan {
  double window_s = 1.0;          ///< One beyond the length of a run takes the whole run.
  double settling_s = 0.0;        ///< At a window's beginning, that does not count.
  std::size_t most_windows = 60;  ///< Evenly spread over the log.
  bool keeps_traces = false;
};

/// Whether a robot of the rig can be simulated under its own loops: every joint has the law of its
/// controller.
bool can_roll_out(const Rig& rig);

/// Simulates the whole robot under its joints' own laws, from the state measured at the beginning
/// of each window, and compares positions. Requires can_roll_out() of the model's rig.
Rollout roll_out(const Log& log, const RobotModel& model, const RolloutPlan& plan,
                 const std::function<void(double share)>& on_progress = {});

/// Simulated less measured positions of a limb's joints, (samples) for each; empty where the
/// simulation grows without bound. `longest_step_s`: of the integration.
std::vector<std::vector<double>> limb_errors_rad(const RobotModel& model, const Limb& limb,
                                                 const Run& run, const Window& window,
                                                 double longest_step_s);

}  // namespace torquewright::identification
