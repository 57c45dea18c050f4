// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/search/plan_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "hopper/planning/objectives/library.hpp"
#include "hopper/planning/programme/flip_program.hpp"
#include "hopper/planning/programme/ground_in_samples.hpp"
#include "hopper/planning/programme/guess.hpp"
#include "hopper/planning/programme/integration_error.hpp"
#include "hopper/planning/programme/mesh_refinement.hpp"
#include "hopper/planning/programme/plan_setup.hpp"
#include "hopper/planning/programme/sampled_motion.hpp"
#include "hopper/planning/programme/solved_motion.hpp"
#include "hopper/planning/programme/warm_guess.hpp"
#include "hopper/planning/result/binding.hpp"
#include "hopper/planning/result/least_margins.hpp"
#include "hopper/planning/search/prices.hpp"
#include "io/faults/spec_error.hpp"
#include "optimization/nonlinear/solve.hpp"

namespace torquewright::hopper {
namespace {

using optimization::NonlinearSolution;
using optimization::NonlinearStatus;

constexpr double kTolerance = 1e-6;   // of scaled rows and optimality; a choice of ours
constexpr double kColdBarrier = 0.1;  // Ipopt's own start value, for a search far from any solution
// Barriers for searches that begin near a solution: after the first mesh, whose solution may be off
// by much, and after those that follow. Choices of ours, tried on the hopper's flip: a greater one
// takes more iterations, 1e-6 after the first mesh nearly twice as many.
constexpr double kWarmBarrier = 1e-4;
constexpr double kNearBarrier = 1e-6;
// Largest residual of a plan at any instant, as a share of what `hopper check` allows as a
// mean over its window: a plan that keeps to it passes there.
constexpr double kUnexplainedShare = 1.0;
// How far what the ground gives may leave its margins between knots, in shares of the foot (2 mm of
// the hopper's) and of the friction coefficient; and how many rounds that may cost a plan.
constexpr double kMostExcess = 0.01;
constexpr int kGroundRounds = 2;
constexpr double kUnknownError_rad = std::numeric_limits<double>::infinity();
constexpr double kRefinedShare = 0.5;  // of what is allowed, which a finer mesh aims at (ours)

/// What of a check speaks against a motion, the gravest first.
std::string failure_sentence(const HopperReport& report) {
  const actuator::Finding* worst = nullptr;
  for (const actuator::Finding& finding : report.check.findings) {
    if (finding.severity == actuator::Severity::kNote) continue;
    if (worst == nullptr || finding.severity > worst->severity) worst = &finding;
  }
  return fmt::format("the solver's motion does not pass hopper check ({}){}",
                     actuator::name_of(report.check.verdict),
                     worst == nullptr ? "" : ": " + worst->sentence);
}

/// One plan on its way, from mesh to mesh.
class Planner {
 public:
  Planner(const Robot& robot, const PlanOptions& options)
      : robot_(robot),
        options_(options),
        model_(plan_model(robot, options)),
        goal_(plan_goal(model_, options)),
        stances_(plan_stances(model_.plane, options)),
        mesh_(first_mesh(stances_, options)),
        begin_(std::chrono::steady_clock::now()) {}

  PlanResult plan();

 private:
  PlannedMotion first_guess() const;
  NonlinearSolution solve(const FlipProgram& program, double barrier);
  bool take_round(const PlannedMotion& guess, double barrier);
  bool is_done();
  bool may_refine() const { return std::ssize(result_.rounds) <= options_.most_rounds; }
  bool keeps_plan();
  bool refine();
  void refine_for_physics();
  bool refine_for_check();
  std::vector<double> excess(std::size_t phase) const;
  bool refine_for_ground();
  bool is_passed() const;
  /// Of a moment that nothing explains, as `hopper check` has it.
  double most_unexplained_Nm() const {
    return kUnexplainedShare * options_.check.residual_share * model_.weight_N * model_.size_m;
  }
  bool is_fine() const {
    return std::all_of(errors_.begin(), errors_.end(), [this](const PhaseError& error) {
      return error.whole_rad <= options_.most_error_rad &&
             error.greatest_unexplained_Nm() <= most_unexplained_Nm();
    });
  }
  void judge();
  Site site(std::size_t phase = 0) const {
    return {model_, goal_, options_, solved_.program.mesh, solved_.program.phases, nullptr, phase};
  }
  std::vector<BoundPrice> prices() const;
  PlanResult answer();
  std::vector<ObjectivePart> parts_of(const FlipProgram& program,
                                      const std::vector<double>& values) const;
  void end(PlanStatus status, std::string reason) {
    result_.status = status;
    result_.reason = std::move(reason);
  }
  void end_unsolved(const NonlinearSolution& solution);
  double seconds_left() const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    return options_.most_seconds - spent.count();
  }

  const Robot& robot_;
  const PlanOptions& options_;
  PlanModel model_;
  PlanGoal goal_;
  std::vector<Stance> stances_;
  std::vector<MeshPhase> mesh_;
  std::chrono::steady_clock::time_point begin_;
  std::vector<PhaseError> errors_;
  SolvedProgram solved_;  ///< Of the last round.
  /// A plan and its program, should further rounds end without one.
  std::optional<PlanResult> kept_;
  SolvedProgram kept_solved_;
  int ground_rounds_ = 0;
  bool is_refined_ = false;  ///< For the ground, by is_done().
  PlanResult result_;
};

PlannedMotion Planner::first_guess() const {
  if (options_.warm == nullptr) return key_frame_guess(model_, mesh_, goal_, options_);
  return warm_guess(robot_, model_, stances_, *options_.warm, options_.check.contact,
                    options_.warm_file);
}

NonlinearSolution Planner::solve(const FlipProgram& program, double barrier) {
  optimization::NonlinearOptions solver;
  solver.tolerance = kTolerance;
  solver.most_iterations = options_.most_iterations;
  solver.most_seconds = std::max(0.0, seconds_left());
  solver.first_barrier = barrier;
  solver.should_stop = options_.should_stop;
  PlanProgress progress{static_cast<int>(result_.rounds.size()), 0, 0, 0.0, 0.0};
  for (const MeshPhase& phase : mesh_) progress.intervals += static_cast<int>(phase.intervals());
  solver.on_iterate = [&](const optimization::NonlinearIterate& iterate) {
    if (!options_.on_progress) return;
    progress.iteration = iterate.iteration;
    progress.objective = iterate.objective;
    progress.largest_violation = iterate.largest_violation;
    options_.on_progress(progress);
  };
  return optimization::solve(program.program, solver);
}

/// Solves on the mesh as it is. False where nothing was found; the result then says why.
bool Planner::take_round(const PlannedMotion& guess, double barrier) {
  solved_ = {flip_program(model_, mesh_, goal_, options_, guess), guess, {}};
  const FlipProgram& program = solved_.program;
  solved_.solution = solve(program, barrier);
  const NonlinearSolution& solution = solved_.solution;
  PlanRound round;
  for (const MeshPhase& phase : mesh_) round.intervals += static_cast<int>(phase.intervals());
  round.iterations = solution.iterations;
  round.solver = optimization::name_of(solution.status);
  round.objective = solution.objective;
  round.largest_violation = solution.largest_violation;
  round.seconds = solution.seconds;
  round.derivative_seconds = solution.derivative_seconds;
  result_.iterations += solution.iterations;
  result_.objective = solution.objective;
  result_.largest_violation = solution.largest_violation;
  result_.plan = motion_of(program, model_, solution.values);
  result_.binding =
      binding_constraints(program, model_, goal_, options_, result_.plan, solution.values);
  result_.objectives = parts_of(program, solution.values);
  errors_ = integration_errors(model_.plane, stances_, result_.plan);
  for (const PhaseError& error : errors_) {
    round.integration_error_rad = std::max(round.integration_error_rad, error.whole_rad);
  }
  result_.integration_error_rad = round.integration_error_rad;
  result_.rounds.push_back(round);
  result_.check.reset();
  if (!solution.is_solved()) end_unsolved(solution);
  return solution.is_solved();
}

/// What each objective came to.
std::vector<ObjectivePart> Planner::parts_of(const FlipProgram& program,
                                             const std::vector<double>& values) const {
  std::vector<ObjectivePart> parts;
  for (const WeightedObjective& one : objectives_of(options_)) {
    const Objective& objective = objective_named(one.name);
    parts.push_back({one.name, one.weight, objective.value(model_, options_, program, values),
                     std::string(objective.unit)});
  }
  return parts;
}

void Planner::end_unsolved(const NonlinearSolution& solution) {
  if (solution.status == NonlinearStatus::kInterrupted) {
    return end(PlanStatus::kLimit, "it was interrupted before the solver had a plan");
  }
  if (solution.status == NonlinearStatus::kTimeLimit) {
    return end(PlanStatus::kLimit,
               fmt::format("the solver had no plan after {:g} s", options_.most_seconds));
  }
  if (solution.status == NonlinearStatus::kLocallyInfeasible) {
    return end(PlanStatus::kLocallyInfeasible,
               "the solver found no motion near its guess that meets all constraints; that proves "
               "nothing about motions elsewhere");
  }
  end(PlanStatus::kLimit,
      fmt::format("the solver ended without a plan: {}", optimization::name_of(solution.status)));
}

/// Nothing that a finer mesh could mend.
bool Planner::is_done() {
  if (!is_fine()) return false;
  judge();
  return !result_.check || (is_passed() && !keeps_plan());
}

/// Keeps the round's plan and refines once more where what the ground gives leaves its margins
/// between knots. False where there is nothing to refine, or it was done often enough.
bool Planner::keeps_plan() {
  if (ground_rounds_ == kGroundRounds || !may_refine() || !refine_for_ground()) return false;
  ++ground_rounds_;
  end(PlanStatus::kPlanned, "");
  kept_ = result_;
  kept_solved_ = std::move(solved_);
  return true;
}

/// False where that is no more allowed, or would not help.
bool Planner::refine() {
  if (!may_refine()) return false;
  if (std::exchange(is_refined_, false)) return true;
  judge();
  if (is_fine()) return refine_for_check();
  refine_for_physics();
  return true;
}

/// Cuts the phases whose error is too great, and where what the ground gives leaves its margins.
void Planner::refine_for_physics() {
  for (std::size_t p = 0; p < mesh_.size(); ++p) {
    const PhaseError& error = errors_[p];
    const bool drifts = error.whole_rad > options_.most_error_rad;
    const auto intervals = static_cast<double>(mesh_[p].intervals());
    const double allowed_rad = kRefinedShare * options_.most_error_rad;
    // An error that no interval shows by itself grows from one to the next: all are cut.
    const bool is_all = drifts && std::ranges::max(error.interval_rad) <= allowed_rad / intervals;
    const std::vector<double> beyond = excess(p);
    std::vector<double> interval = error.interval_rad;
    for (std::size_t i = 0; i < interval.size(); ++i) {
      if (!drifts) interval[i] = 0.0;
      const bool is_cut = is_all || beyond[i] > kRefinedShare * kMostExcess ||
                          error.unexplained_Nm[i] > most_unexplained_Nm();
      if (is_cut) interval[i] = kUnknownError_rad;
    }
    mesh_[p].knots = refined(mesh_[p].knots, interval, allowed_rad);
  }
}

/// Limits hold at knots and middles; cuts the intervals in which one is passed between them. False
/// where there is none.
bool Planner::refine_for_check() {
  bool is_cut = false;
  for (std::size_t p = 0; p < mesh_.size(); ++p) {
    const PlannedPhase& phase = result_.plan.phases[p];
    std::vector<double> interval(phase.intervals(), 0.0);
    for (const actuator::Finding& finding : result_.check->check.findings) {
      if (finding.severity != actuator::Severity::kViolation || !finding.time_s) continue;
      for (std::size_t i = 0; i < interval.size(); ++i) {
        const bool is_within = phase.instants[2 * i].time_s < *finding.time_s &&
                               *finding.time_s < phase.instants[2 * i + 2].time_s;
        if (is_within) interval[i] = kUnknownError_rad;
      }
    }
    std::vector<double> finer = refined(mesh_[p].knots, interval, options_.most_error_rad);
    is_cut = is_cut || finer.size() > mesh_[p].knots.size();
    mesh_[p].knots = std::move(finer);
  }
  return is_cut;
}

std::vector<double> Planner::excess(std::size_t phase) const {
  if (!result_.check) return std::vector<double>(mesh_[phase].intervals(), 0.0);
  return ground_excess(site(phase), result_.plan.phases[phase], result_.motion.times_s,
                       result_.check->demand.forces_N);
}

/// Cuts the intervals in which what the ground gives leaves its margins, where it does so anywhere
/// by more than it may. False where it does not.
bool Planner::refine_for_ground() {
  for (std::size_t p = 0; p < mesh_.size(); ++p) {
    is_refined_ = is_refined_ || std::ranges::max(excess(p)) > kMostExcess;
  }
  for (std::size_t p = 0; is_refined_ && p < mesh_.size(); ++p) {
    const auto intervals = static_cast<double>(mesh_[p].intervals());
    mesh_[p].knots = refined(mesh_[p].knots, excess(p), intervals * kRefinedShare * kMostExcess);
  }
  return is_refined_;
}

/// By `hopper check`, once a round. What it refuses has no report; of a solution its refusal is the
/// reason.
void Planner::judge() {
  if (result_.check) return;
  result_.motion = sampled_motion(robot_, model_.plane, result_.plan, options_.sample_s);
  result_.motion.ground = goal_.ground;
  CheckOptions all_rows = options_.check;
  all_rows.left_out_share = 0.0;  // of a solution no row is an error of a recording
  try {
    result_.check = check_motion(robot_, result_.motion, all_rows);
  } catch (const io::SpecError& refusal) {
    if (result_.status != PlanStatus::kCheckFails) return;  // no solution: that is the reason
    return end(PlanStatus::kCheckFails,
               fmt::format("hopper check refuses the solver's motion{}", refusal.what()));
  }
  result_.least_margins = least_margins(robot_, result_.motion, *result_.check);
  result_.angular_momentum_Nm_s = 0.0;
  for (const Flight& flight : result_.check->flights) {
    if (flight.angular_momentum_Nm_s < result_.angular_momentum_Nm_s) continue;
    result_.angular_momentum_Nm_s = flight.angular_momentum_Nm_s;
    result_.take_off_rad_s = flight.take_off_rad_s;
    result_.peak_rad_s = flight.peak_rad_s;
  }
}

/// `hopper check` passes it. A plan in boxes is not held against regions and battery, which are
/// what a box leaves out: all other rules must let it pass.
bool Planner::is_passed() const {
  if (options_.limits == DriveLimits::kMor) {
    return result_.check->check.verdict == actuator::Verdict::kPass;
  }
  const std::vector<actuator::Finding>& findings = result_.check->check.findings;
  return std::all_of(findings.begin(), findings.end(), [](const actuator::Finding& finding) {
    return finding.severity != actuator::Severity::kViolation ||
           finding.rule == "motor-operating-region" || finding.rule == "battery-power";
  });
}

/// Of the round's plan.
std::vector<BoundPrice> Planner::prices() const {
  const KeptMargins kept =
      kept_margins(site(), result_.plan, result_.motion, result_.check->demand.forces_N);
  return bound_prices(robot_, options_, solved_, kept);
}

/// What the search came to, but a plan of an earlier round where the last one is none.
PlanResult Planner::answer() {
  if (result_.status != PlanStatus::kPlanned && kept_) {
    kept_->rounds = std::move(result_.rounds);
    kept_->iterations = result_.iterations;
    result_ = std::move(*kept_);
    solved_ = std::move(kept_solved_);
  }
  if (result_.status == PlanStatus::kPlanned) result_.prices = prices();
  return std::move(result_);
}

PlanResult Planner::plan() {
  bool is_solved = take_round(first_guess(), kColdBarrier);
  while (is_solved && !is_done() && refine()) {
    const PlannedMotion last = result_.plan;
    const double barrier = result_.rounds.size() == 1 ? kWarmBarrier : kNearBarrier;
    is_solved = take_round(last, barrier) || take_round(last, kColdBarrier);
  }
  if (is_solved) end(PlanStatus::kCheckFails, "");
  judge();
  if (!is_solved || !result_.check) return answer();
  if (!is_fine()) {
    end(PlanStatus::kCheckFails,
        fmt::format("on the finest mesh tried, integrating the torques leads {} away from the "
                    "plan; {:.2g} is allowed",
                    std::isfinite(result_.integration_error_rad)
                        ? fmt::format("{:.2g} rad", result_.integration_error_rad)
                        : "without bound",
                    options_.most_error_rad));
  } else if (!is_passed()) {
    end(PlanStatus::kCheckFails, failure_sentence(*result_.check));
  } else {
    end(PlanStatus::kPlanned, "");
  }
  return answer();
}

}  // namespace

PlanResult search_plan(const Robot& robot, const PlanOptions& options) {
  return Planner(robot, options).plan();
}

}  // namespace torquewright::hopper
