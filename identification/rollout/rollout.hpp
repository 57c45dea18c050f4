// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/log/log.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// How far simulated joints are from measured ones: root mean square over all samples of all
/// windows.
struct RolloutError {
  double all_rad = 0.0;              ///< Over all joints.
  std::vector<double> by_joint_rad;  ///< In the rig's order.
  std::size_t windows = 0;           ///< Number of windows; 0: none, and no error is known.
  std::size_t diverged = 0;  ///< Of these, those left out whose simulation grew without bound.
};

/// Errors of windows of one length.
struct Rollout {
  double window_s = 0.0;
  RolloutError train, holdout;
};

/// Whether a robot of the rig can be simulated under its own loops: every joint has the law of its
/// controller.
bool can_roll_out(const Rig& rig);

/// Simulates the whole robot under its joints' own laws, from the state measured at the beginning
/// of each window, and compares positions. `windows_s`: lengths; one beyond the length of a run
/// takes the whole run. `most_windows` of each length, evenly spread. Requires can_roll_out();
/// actuators in the rig's order.
std::vector<Rollout> roll_out(const Rig& rig, const Log& log,
                              const std::vector<const actuator::Actuator*>& actuators,
                              const std::vector<double>& windows_s, std::size_t most_windows,
                              const std::function<void(double share)>& on_progress = {});

}  // namespace torquewright::identification
