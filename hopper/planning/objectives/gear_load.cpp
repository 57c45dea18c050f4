// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/planning/model/gear_laws.hpp"
#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/every_objective.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kTypical = 0.9;  // of a gear's limit, in the hopper's flip of least effort
constexpr double kMost = 100.0;   // of limits; no plan is near it

/// What each drive's gears may pass, at its output: their limit, or the greatest torque of a drive
/// that states none.
std::vector<double> limits_Nm(const PlanModel& model) {
  std::vector<double> out = model.gear_Nm;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!std::isfinite(out[i])) out[i] = (*model.regions)[i].greatest_torque_Nm();
  }
  return out;
}

struct LinearLaw {
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    rows[0] = factor * x[0];
  }
};

/// Phases that begin with an impact. Refuses where there is none.
std::vector<std::size_t> impacts(const FlipProgram& program) {
  std::vector<std::size_t> out;
  for (std::size_t phase = 0; phase < program.phases.size(); ++phase) {
    if (program.phases[phase].has_impact) out.push_back(phase);
  }
  if (out.empty()) {
    io::refuse("--objective", "gear_load is about landings, and no phase of this motion has one");
  }
  return out;
}

/// How many instants of a phase lie in the window after its begin, by the guess's duration: up to
/// the first knot past it.
std::size_t instants_within(const FlipProgram& program, std::size_t phase, double window_s) {
  const std::vector<double>& knots = program.mesh[phase].knots;
  const double duration_s =
      program.program.starts()[static_cast<std::size_t>(program.phases[phase].duration)];
  std::size_t interval = 1;
  while (interval + 1 < knots.size() && knots[interval] * duration_s < window_s) ++interval;
  return 2 * interval + 1;
}

struct Builder {
  const PlanModel& model;
  FlipProgram& program;
  std::vector<double> limits;
  double window_s;
  int greatest;
  Eigen::Index k = static_cast<Eigen::Index>(model.plane.joints.size());
  Eigen::Index d = static_cast<Eigen::Index>(limits.size());

  template <typename Law>
  void add_rows(const char* name, std::vector<int> numbers, Law law, bool adds) {
    const auto rows = static_cast<std::size_t>(2 * d);
    program.program.add_rows(jet_rows(
        name, std::move(numbers), std::vector<optimization::Bounds>(rows, {-kInfinite, 0.0}),
        std::vector<double>(rows, 1.0), MagnitudeLaw<Law>{std::move(law), d, adds}));
  }

  void add(std::size_t phase) {
    const PhaseVariables& variables = program.phases[phase];
    const auto drives = static_cast<std::size_t>(d);
    const int impulses =
        program.program.add({"impulse loads", std::vector<double>(drives, 0.1),
                             std::vector<optimization::Bounds>(drives, {0.0, kMost}),
                             std::vector<double>(drives, kTypical)});
    add_rows("rotors at the impact",
             in_order({impulse_numbers(variables, k), numbers_from(impulses, d)}),
             ImpulseLaw{&model, limits, window_s}, false);
    for (std::size_t i = 0; i < instants_within(program, phase, window_s); ++i) {
      add_rows(
          "gears after the impact",
          in_order(
              {gear_numbers(variables.points[i], k, d), numbers_from(impulses, d), {greatest}}),
          GearLaw{&model, limits}, true);
    }
  }
};

/// The rotor's impulse and the torque that follows count with their sizes, as in (12). The greatest
/// of all landings, drives and instants is what it costs.
void add(const PlanModel& model, const PlanOptions& options, double weight, FlipProgram& program) {
  const std::vector<std::size_t> phases = impacts(program);
  const int greatest =
      program.program.add({"greatest gear load", {1.0}, {{0.0, kMost}}, {kTypical}});
  Builder builder{model, program, limits_Nm(model), options.check.load_window_s, greatest};
  for (const std::size_t phase : phases) builder.add(phase);
  program.program.add_cost(
      jet_cost("gear load", {greatest}, LinearLaw{weight * kTypicalCost / kTypical}));
}

Eigen::VectorXd picked(const std::vector<int>& numbers, const std::vector<double>& values) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    out[static_cast<Eigen::Index>(i)] = values[static_cast<std::size_t>(numbers[i])];
  }
  return out;
}

/// By drive, the greatest of all landings over its limit.
Eigen::VectorXd loads(const PlanModel& model, double window_s, const FlipProgram& program,
                      const std::vector<double>& values) {
  const auto k = static_cast<Eigen::Index>(model.plane.joints.size());
  const auto d = static_cast<Eigen::Index>(model.plane.drive_count());
  const std::vector<double> limits = limits_Nm(model);
  Eigen::VectorXd greatest = Eigen::VectorXd::Zero(d), impulse(d), torque(d);
  for (const std::size_t phase : impacts(program)) {
    const PhaseVariables& variables = program.phases[phase];
    ImpulseLaw{&model, limits, window_s}(picked(impulse_numbers(variables, k), values), impulse);
    for (std::size_t i = 0; i < instants_within(program, phase, window_s); ++i) {
      GearLaw{&model, limits}(picked(gear_numbers(variables.points[i], k, d), values), torque);
      greatest = greatest.cwiseMax(impulse.cwiseAbs() + torque.cwiseAbs());
    }
  }
  return greatest;
}

double value(const PlanModel& model, const PlanOptions& options, const FlipProgram& program,
             const std::vector<double>& values) {
  const Eigen::VectorXd load = loads(model, options.check.load_window_s, program, values);
  Eigen::Index worst = 0;
  load.maxCoeff(&worst);
  Eigen::Index first = 0;
  for (const Drivetrain& drivetrain : model.plane.robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) {
      if (first++ != worst) continue;
      // By the mesh that drives forwards, as the limit's side is changed.
      const actuator::Transmission& gears = actuator.transmission;
      return load[worst] * limits_Nm(model)[static_cast<std::size_t>(worst)] /
             (std::abs(gears.ratio) * gears.forward_efficiency);
    }
  }
  return 0.0;
}

}  // namespace

const Objective objectives::gear_load{
    "gear_load",
    "least load of the gears in landings, over each gear's limit: the torque that passes them in "
    "the window after a contact and the rotor's impulse spread over it, of the worst drive, at its "
    "motor's side",
    "Nm", add, value};

}  // namespace torquewright::hopper
