// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hopper/check/hopper_check.hpp"
#include "hopper/flip/planned_motion.hpp"
#include "hopper/replay/powered_drive_options.hpp"

namespace torquewright::hopper {

enum class PlanTask {
  kFlip,  ///< From a stance to the same stance, the foot turned once forwards.
  kJump,  ///< As high as asked for at least, and down on the same place.
  kHop,   ///< The same with a stride.
};
std::string_view name_of(PlanTask task);

enum class PlanStatus {
  kPlanned,            ///< Found, and `hopper check` passes it.
  kLocallyInfeasible,  ///< None found from this guess; proves nothing.
  kCheckFails,         ///< Found, but `hopper check` does not pass it, or its error is too great.
  kLimit,              ///< A limit of time, or Ctrl-C, came first.
};
std::string_view name_of(PlanStatus status);

/// What a plan keeps away from limits, so that a replay has something left to steer with.
struct PlanMargins {
  double voltage = 0.02;              ///< Of the bus voltage that a region is asked at.
  double current = 0.08;              ///< Of the region's bound where current is what limits.
  double friction = 0.15;             ///< Of each point's friction coefficient.
  double center_of_pressure = 0.1;    ///< Of the foot's length, from either end.
  double gear_load = 0.1;             ///< Of each transmission's limit.
  double position_rad = 0.02;         ///< From the ends of joints' ranges.
  double speed = 0.02;                ///< Of joints' speed limits.
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
  PlanTask task = PlanTask::kFlip;
  DriveLimits limits = DriveLimits::kMor;
  double rise_m = 0.1;    ///< Of the centre of mass in the flight of a jump or a hop, at least.
  double stride_m = 0.1;  ///< Of a hop, forwards.
  std::vector<std::string> stances;            ///< "flat", "heel", "flight", ...; empty: the task's.
  std::vector<WeightedObjective> objectives;   ///< Empty: the task's.
  PlanMargins margins;
  int intervals = 180;                         ///< Of the first mesh, all phases together.
  double most_error_rad = 2e-3;                ///< Of a phase, by an independent integrator.
  int most_rounds = 6;                         ///< Meshes after the first.
  double most_seconds = 600.0;
  int most_iterations = 1000;                  ///< A mesh.
  double guess_noise_rad = 0.0;                ///< Perturbs the first guess's joint angles,
  unsigned guess_seed = 0;                     ///< with numbers of this seed.
  double sample_s = 1e-3;                      ///< Of the motion that is written.
  const Motion* warm = nullptr;                ///< A motion of this robot to begin from, or none.
  std::string warm_file;                       ///< Its name in messages.
  CheckOptions check;                          ///< Conditions, ground, window of the gear load.
  /// Where none is found: look for the smallest change of one thing that makes one.
  bool explain = false;
  std::function<bool()> should_stop = {};                           ///< May be empty.
  std::function<void(const PlanProgress& progress)> on_progress = {};  ///< May be empty.
};

/// How far a plan is from a rule's limit at least. A value at its limit has margin 0.
struct LeastMargin {
  std::string rule;   ///< "motor-operating-region", "friction-cone", ...
  std::string place;  ///< Drive, joint, contact point.
  double time_s = 0.0;
  double value = 0.0;
  double limit = 0.0;
  double margin = 0.0;  ///< In `unit`, planning margin not counted: of the rule itself.
  std::string unit;
};

/// A constraint that holds a plan back.
struct BindingConstraint {
  std::string name;          ///< "knee: region, upper".
  std::string stance;
  std::size_t instants = 0;  ///< At which it binds,
  std::size_t of = 0;        ///< of so many.
  double from_s = 0.0;
  double until_s = 0.0;
  double violation = 0.0;    ///< The greatest, in `unit`, where the plan is infeasible.
  std::string unit;
};

/// A mesh and what came of it.
struct PlanRound {
  int intervals = 0;
  int iterations = 0;
  std::string solver;  ///< Words of its outcome.
  double objective = 0.0;
  double largest_violation = 0.0;
  double integration_error_rad = 0.0;
  double seconds = 0.0;
  double derivative_seconds = 0.0;
};

/// Of one objective, unweighted.
struct ObjectivePart {
  std::string name;
  double weight = 0.0;
  double value = 0.0;
  std::string unit;
};

/// A change of one thing, everything else as it is, with which a plan was found where there had
/// been none: the smallest of those tried, not of all that there are.
struct ChangeTried {
  std::string quantity;  ///< "voltage", "current", "mass", or a ratio by its drive: "knee_ratio".
  double from = 0.0;     ///< As the documents have it, in `unit`.
  double to = 0.0;       ///< What made a plan; the farthest tried where nothing did.
  std::string unit;
  bool has_plan = false;
  bool is_cut_off = false;  ///< A limit of time, or Ctrl-C, came before its last answer.
};

struct PlanResult {
  PlanStatus status = PlanStatus::kLimit;
  std::string reason;  ///< A sentence; empty where planned.
  PlannedMotion plan;  ///< Empty without phases only where nothing was found.
  Motion motion;       ///< The same, sampled: what was checked and what is written.
  std::optional<HopperReport> check;
  double objective = 0.0;
  std::vector<ObjectivePart> objectives;
  int iterations = 0;  ///< Of all rounds.
  double largest_violation = 0.0;  ///< Of scaled rows.
  double integration_error_rad = 0.0;  ///< Of the worst phase.
  double angular_momentum_Nm_s = 0.0;  ///< CAM of the longest flight; 0 without one. Signed: +y.
  double take_off_rad_s = 0.0;         ///< CAV there,
  double peak_rad_s = 0.0;             ///< and its greatest.
  std::vector<LeastMargin> least_margins;  ///< One a rule, the least first.
  std::vector<BindingConstraint> binding;  ///< The most often binding first.
  std::vector<PlanRound> rounds;
  std::vector<ChangeTried> changes;  ///< Where asked to explain.
};

/// Plans a motion in the sagittal plane by direct collocation; docs/derivations/collocation.md.
/// Throws io::SpecError where robot or options cannot be planned with at all: a robot that is not
/// symmetric about the plane or cannot stand, no gravity, a warm motion of another robot.
PlanResult plan_motion(const Robot& robot, const PlanOptions& options);

}  // namespace torquewright::hopper
