// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "hopper/engines/engine.hpp"
#include "hopper/record/record.hpp"
#include "hopper/replay/powered_drives.hpp"
#include "hopper/surroundings/push.hpp"
#include "hopper/tracking/controller.hpp"
#include "hopper/trials/trial_start.hpp"

namespace torquewright::hopper {

/// Times of a run in whole numbers of the engine's steps, so that no time drifts.
struct RunOptions {
  double step_s = 1e-4;
  int steps_per_control = 5;
  int latency_steps = 0;  ///< Delay from a look at the robot to the torque that answers it.
  double stand_s = 1.0;   ///< Time for which the robot is watched after the motion's end.
  double ground_height_m = 0.0;
  simulation::GroundProfile profile = {};  ///< Over that height.
  /// Each acts for the step of the engine in which its time falls.
  std::vector<Push> pushes = {};
};

/// Who takes part in a run. All of one robot, which may differ from the one that the controller
/// believes to have.
struct RunParts {
  const Robot& robot;  ///< The robot as the engine moves it: without_free_rotors().
  const Reference& reference;
  Engine& engine;
  Controller& controller;
  PoweredDrives& drives;
  RunStart start;
  /// The share of what the controller's feedback asks of each drive that arrives; empty: all of it.
  Eigen::VectorXd gain_factor = {};
  /// Turns what is into what sensors say, at each look, by its number; may be empty.
  std::function<void(std::uint64_t look, Observation& seen)> sense = {};
  std::function<bool()> should_stop = {};  ///< Called to ask whether to stop. May be empty.
  /// Called with the share that is done. May be empty.
  std::function<void(double share)> on_progress = {};
};

/// Runs from its start, at the reference's begin, until its end and stand_s more, or until the
/// robot falls or nothing can go on. Every number of the record is finite.
Record run_replay(const RunParts& parts, const RunOptions& options);

}  // namespace torquewright::hopper
