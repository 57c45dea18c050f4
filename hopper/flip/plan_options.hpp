// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hopper/check/checked_motion.hpp"
#include "hopper/flip/tasks/every_task.hpp"
#include "hopper/replay/powered_drive_options.hpp"

namespace torquewright::hopper {

/// What a plan keeps away from limits, so that a replay has something left to steer with.
struct PlanMargins {
  double voltage = 0.01;            ///< Of the bus voltage that a region is asked at.
  double current = 0.08;            ///< Of the region's bound where current is what limits.
  double friction = 0.15;           ///< Of each point's friction coefficient.
  double center_of_pressure = 0.1;  ///< Of the foot's length, from either end.
  double gear_load = 0.1;           ///< Of each transmission's limit.
  double position_rad = 0.02;       ///< From the ends of joints' ranges.
  double speed = 0.02;              ///< Of joints' speed limits.
};

/// A cost by name (hopper/flip/objectives/) and how much it counts.
struct WeightedObjective {
  std::string name;
  double weight = 1.0;
};

/// How far a plan has come.
struct PlanProgress {
  int round = 0;  ///< 0: first mesh.
  int iteration = 0;
  int intervals = 0;
  double objective = 0.0;
  double largest_violation = 0.0;
};

struct PlanOptions {
  const PlanTask* task = &tasks::flip;
  DriveLimits limits = DriveLimits::kMor;
  double rise_m = 0.1;    ///< Of the centre of mass in the flight of a jump or a hop, at least.
  double stride_m = 0.1;  ///< Of a hop, forwards.
  std::vector<std::string> stances;           ///< "flat", "heel", "flight", ...; empty: the task's.
  std::vector<WeightedObjective> objectives;  ///< Empty: the task's.
  PlanMargins margins;
  int intervals = 100;           ///< Of the first mesh, all phases together.
  double most_error_rad = 2e-3;  ///< Of a phase, by an independent integrator.
  int most_rounds = 6;           ///< Meshes after the first.
  double most_seconds = 600.0;
  int most_iterations = 1000;    ///< A mesh.
  double guess_noise_rad = 0.0;  ///< Perturbs the first guess's joint angles,
  unsigned guess_seed = 0;       ///< with numbers of this seed.
  double sample_s = 1e-3;        ///< Of the motion that is written.
  const Motion* warm = nullptr;  ///< A motion of this robot to begin from, or none.
  std::string warm_file;         ///< Its name in messages.
  CheckOptions check;            ///< Conditions, ground, window of the gear load.
  /// Where none is found: look for the smallest change of one thing that makes one.
  bool explain = false;
  std::function<bool()> should_stop = {};                              ///< May be empty.
  std::function<void(const PlanProgress& progress)> on_progress = {};  ///< May be empty.
};

}  // namespace torquewright::hopper
