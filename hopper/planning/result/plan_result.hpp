// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hopper/check/hopper_check.hpp"
#include "hopper/planning/plane/planned_motion.hpp"

namespace torquewright::hopper {

enum class PlanStatus {
  /// Found, and `hopper check` passes it; planned in boxes, all but regions and battery do.
  kPlanned,
  kLocallyInfeasible,  ///< None found from this guess; proves nothing.
  /// The solver found a motion, but `hopper check` does not pass it, or its integration error is
  /// too great. Undecided, as a limit is, and of the same name.
  kCheckFails,
  kLimit,  ///< A limit of time, or Ctrl-C, came first.
};
std::string_view name_of(PlanStatus status);

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
  std::string name;  ///< "knee: region, upper".
  std::string stance;
  std::size_t instants = 0;  ///< At which it binds,
  std::size_t of = 0;        ///< of so many.
  double from_s = 0.0;
  double until_s = 0.0;
  double violation = 0.0;  ///< The greatest, in `unit`, where the plan is infeasible.
  std::string unit;
  bool has_times = true;  ///< False: rows of the program, without any.
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

/// What one objective comes to in a plan, unweighted.
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
  int iterations = 0;                  ///< Of all rounds.
  double largest_violation = 0.0;      ///< Of scaled rows.
  double integration_error_rad = 0.0;  ///< Of the worst phase.
  double angular_momentum_Nm_s = 0.0;  ///< CAM of the longest flight; 0 without one. Signed: +y.
  double take_off_rad_s = 0.0;         ///< CAV there,
  double peak_rad_s = 0.0;             ///< and its greatest.
  std::vector<LeastMargin> least_margins;  ///< One a rule, the least first.
  std::vector<BindingConstraint> binding;  ///< As of binding_constraints().
  std::vector<PlanRound> rounds;
  std::vector<ChangeTried> changes;  ///< Where asked to explain.
};

}  // namespace torquewright::hopper
