// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hopper/demand/checked_motion.hpp"
#include "hopper/planning/tasks/every_task.hpp"
#include "hopper/replay/powered_drive_options.hpp"

namespace torquewright::hopper {

/// Planning margins, so that a replay has something left to steer with. Choices of ours
/// (docs/flip.md).
struct PlanMargins {
  double voltage = 0.01;   ///< Share of the bus voltage at which a region's voltage bound is taken.
  double current = 0.08;   ///< Share of the region's bound where current is what limits.
  double friction = 0.15;  ///< Share of each point's friction coefficient.
  double center_of_pressure = 0.1;  ///< Share of the foot's length, from either end.
  double gear_load = 0.1;           ///< Share of each transmission's limit.
  double position_rad = 0.02;       ///< Distance from the ends of joints' ranges.
  /// The same in flight, where it is more: a leg on its stops can turn slower and never faster.
  double flight_position_rad = 0.0;
  double speed = 0.02;  ///< Share of joints' speed limits.
  /// Height of the sole above the edges of the ground that it passes in flight: one that is met in
  /// flight ends it.
  double edge_m = 0.0;
  /// Share of the foot's length that the capture point keeps from either end where the last stance
  /// begins (CaptureLaw); 0: it may be anywhere.
  double capture_point = 0.0;
};

/// How long a phase may take at most, in s, by what it is for. The middle phases are those on the
/// ground between the first or the last and a flight. Usually long enough for a robot of a metre to
/// gather itself and to come to rest.
struct LongestPhases {
  double first_s = 0.8;
  double push_off_s = 0.15;  ///< One on an edge that lasts longer has the foot hover.
  double flight_s = 0.8;
  double landing_s = 0.3;
  double between_s = 0.8;  ///< Whole sole between two flights.
  double last_s = 1.0;     ///< A replay falls where it creeps (trial: 1.6 s fell, 1.0 s stood).
};

/// An objective by name (hopper/planning/objectives/) with its weight.
struct WeightedObjective {
  std::string name;
  double weight = 1.0;
};

/// Progress of a plan.
struct PlanProgress {
  int round = 0;  ///< Number of the mesh; 0 is the first.
  int iteration = 0;
  int intervals = 0;
  double objective = 0.0;
  double largest_violation = 0.0;
};

struct PlanOptions {
  const PlanTask* task = &tasks::flip;
  DriveLimits limits = DriveLimits::kMor;
  double rise_m = 0.1;  ///< Least rise of the centre of mass in the flight of a jump or a hop.
  /// Stride of a hop, forwards; empty: the task's, or what the speed makes.
  std::optional<double> stride_m;
  /// Mean speed of the foot from the first take-off to the last touch-down, its sign the stride's;
  /// empty: free.
  std::optional<double> speed_m_s;
  int repeat = 1;               ///< Flights in a row, where `stances` does not say how many.
  bool has_alike_hops = false;  ///< Whether every flight begins as the one before.
  /// How high the ground is where each flight lands, over that where the motion begins; the last
  /// holds for all that follow. Empty: flat ground.
  std::vector<double> landings_m;
  /// Stances in order: "flat", "heel", "flight", ...; empty: the task's.
  std::vector<std::string> stances;
  std::vector<WeightedObjective> objectives;  ///< Objectives with weights; empty: the task's.
  PlanMargins margins;
  double reserve = 0.0;  ///< What margins were made of it (reserve.hpp), for who reads the answer.
  LongestPhases longest;
  int intervals = 100;           ///< Intervals of the first mesh, of one hop.
  double most_error_rad = 2e-3;  ///< Largest error of a phase by an independent integrator.
  int most_rounds = 6;           ///< Most meshes after the first.
  double most_seconds = 600.0;
  int most_iterations = 1000;    ///< Most iterations on a mesh.
  double guess_noise_rad = 0.0;  ///< Perturbation of the first guess's joint angles.
  unsigned guess_seed = 0;       ///< Seed of that perturbation.
  double sample_s = 1e-3;        ///< Step of the motion that is written.
  const Motion* warm = nullptr;  ///< A motion of this robot to begin from, or none.
  std::string warm_file;         ///< Name of `warm` in messages.
  CheckOptions check;            ///< Conditions, ground, window of the gear load.
  /// Where no plan is found: look for the smallest change of one thing that makes one.
  bool explain = false;
  std::function<bool()> should_stop = {};  ///< Called to ask whether to stop. May be empty.
  /// Called after each iteration. May be empty.
  std::function<void(const PlanProgress& progress)> on_progress = {};
};

}  // namespace torquewright::hopper
