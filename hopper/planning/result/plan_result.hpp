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
  /// A plan was found, and `hopper check` passes it; where planned in boxes, all rules but regions
  /// and battery.
  kPlanned,
  kLocallyInfeasible,  ///< None was found from this guess; this proves nothing.
  /// The solver found a motion, but `hopper check` does not pass it, or its integration error is
  /// too great. Undecided, as a limit is, and of the same name.
  kCheckFails,
  kLimit,  ///< A limit of time, or Ctrl-C, came first.
};
std::string_view name_of(PlanStatus status);

/// The least distance of a plan from a rule's limit. A value at its limit has margin 0.
struct LeastMargin {
  std::string rule;   ///< "motor-operating-region", "friction-cone", ...
  std::string place;  ///< Name of the drive, joint or contact point.
  double time_s = 0.0;
  double value = 0.0;
  double limit = 0.0;
  /// Margin to the rule itself, in `unit`; planning margins are not taken off.
  double margin = 0.0;
  std::string unit;
};

/// A number by which a plan was bounded, and what more of it costs.
struct BoundPrice {
  std::string name;  ///< "joint range" of a planning margin, "longest flight" of a duration.
  double value = 0.0;
  std::string unit;  ///< Empty of a share.
  /// How many times the reserve it is; 0 where it is not the reserve's.
  double per_reserve = 0.0;
  /// Growth of the objective per unit more of it, to first order; empty where that cannot be told.
  std::optional<double> objective_per_unit;
  /// The least of a margin that samples of the motion keep; empty where it is not looked for.
  std::optional<double> kept = {};
};

/// Returns the growth of the objective per unit of the reserve; empty where nothing is the
/// reserve's, or a part's price is not known.
std::optional<double> reserve_price(const std::vector<BoundPrice>& prices);

/// A constraint that holds a plan back.
struct BindingConstraint {
  std::string name;  ///< "knee: region, upper".
  std::string stance;
  std::size_t instants = 0;  ///< Number of instants at which it binds.
  std::size_t of = 0;        ///< Number of instants in all.
  double from_s = 0.0;
  double until_s = 0.0;
  double violation = 0.0;  ///< The greatest violation, in `unit`, where the plan is infeasible.
  std::string unit;
  bool has_times = true;  ///< False: a row of the program, which has no times.
};

/// One mesh and the outcome on it.
struct PlanRound {
  int intervals = 0;
  int iterations = 0;
  std::string solver;  ///< The solver's outcome in words.
  double objective = 0.0;
  double largest_violation = 0.0;
  double integration_error_rad = 0.0;
  double seconds = 0.0;
  double derivative_seconds = 0.0;
};

/// Value of one objective in a plan, unweighted.
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
  double from = 0.0;     ///< Value of the documents, in `unit`.
  double to = 0.0;       ///< What made a plan; the farthest tried where nothing did.
  std::string unit;
  bool has_plan = false;
  bool is_cut_off = false;  ///< A limit of time, or Ctrl-C, came before its last answer.
};

struct PlanResult {
  PlanStatus status = PlanStatus::kLimit;
  std::string reason;  ///< A sentence on why there is no plan; empty where there is one.
  PlannedMotion plan;  ///< Empty only where nothing was found.
  Motion motion;       ///< The plan, sampled: what was checked and is written.
  std::optional<HopperReport> check;
  double objective = 0.0;
  std::vector<ObjectivePart> objectives;
  int iterations = 0;                  ///< Iterations of all rounds.
  double largest_violation = 0.0;      ///< Largest violation of scaled rows.
  double integration_error_rad = 0.0;  ///< Integration error of the worst phase.
  /// CAM of the longest flight, positive about +y; 0 without a flight.
  double angular_momentum_Nm_s = 0.0;
  double take_off_rad_s = 0.0;             ///< CAV at its take-off.
  double peak_rad_s = 0.0;                 ///< Greatest CAV in it.
  std::vector<LeastMargin> least_margins;  ///< Least margins, one for each rule, the least first.
  std::vector<BindingConstraint> binding;  ///< See binding_constraints().
  std::vector<BoundPrice> prices;  ///< Planning margins, then longest phases; of a plan alone.
  std::vector<PlanRound> rounds;
  std::vector<ChangeTried> changes;  ///< Changes that were tried, where asked to explain.
};

}  // namespace torquewright::hopper
