// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/floors.hpp"

#include <string>
#include <utility>

#include "gearbox/constraints/condition.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::Expression;
using optimization::Goal;

Rational axial_length_mm(const Problem& problem) {
  Rational sum_mm = 0;
  for (const auto& [layer, width_mm] : problem.face_width_mm) sum_mm += width_mm;
  return sum_mm;
}

/// As a decimal, so that what is a fraction is compared as one.
std::optional<Rational> exact(const std::optional<double>& value) {
  if (!value) return std::nullopt;
  return io::exact(*value);
}

std::optional<Rational> value_of(FloorQuantity quantity, const Problem& problem,
                                 const DesignReport& report) {
  switch (quantity) {
    case FloorQuantity::kForwardEfficiency:
      return exact(report.forward_efficiency);
    case FloorQuantity::kBackwardEfficiency:
      return exact(report.backward_efficiency);
    case FloorQuantity::kHollowShaft:
      return exact(report.hollow_shaft_diameter_mm);
    case FloorQuantity::kAxialLength:
      return axial_length_mm(problem);
    case FloorQuantity::kMass:
      return exact(report.mass_kg);
    case FloorQuantity::kReflectedInertia:
      return exact(report.reflected_inertia_kg_m2);
    case FloorQuantity::kBacklash:
      return exact(report.output_backlash_rad_per_mm);
  }
  return std::nullopt;
}

/// Of the face widths that the problem states.
Goal axial_length_goal(const Problem& problem) {
  return {"axial_length", "mm", Expression(axial_length_mm(problem)), /*maximise=*/false,
          /*exact=*/true};
}

Goal goal_of(FloorQuantity quantity, const Problem& problem, const FloorGoals& goals) {
  switch (quantity) {
    case FloorQuantity::kForwardEfficiency:
      return goals.of_objective(Objective::kForwardEfficiency);
    case FloorQuantity::kBackwardEfficiency:
      return goals.of_objective(Objective::kBackwardEfficiency);
    case FloorQuantity::kHollowShaft:
      return goals.of_objective(Objective::kHollowShaft);
    case FloorQuantity::kMass:
      return goals.of_objective(Objective::kMass);
    case FloorQuantity::kReflectedInertia:
      return goals.of_objective(Objective::kReflectedInertia);
    case FloorQuantity::kBacklash:
      return goals.backlash;
    case FloorQuantity::kAxialLength:
      break;
  }
  return axial_length_goal(problem);
}

bool is_met(const FloorRecord& floor, const Rational& limit, const Rational& value) {
  const Rational from = met_from(floor, limit);
  return floor.is_ceiling ? value <= from : value >= from;
}

ConstraintReport floor_constraint(const FloorRecord& floor, const Rational& limit,
                                  const std::optional<Rational>& value) {
  DesignCondition condition{std::string(floor.name), std::string(floor.key),
                            std::string(floor.unit)};
  condition.sense = floor.is_ceiling ? Sense::kAtMost : Sense::kAtLeast;
  condition.limit = limit;
  condition.meaning = floor.meaning;
  if (!value) return violated_without_value(condition, "has no value: the output stands still.");
  condition.value = *value;
  ConstraintReport report = judge(condition);
  if (report.satisfied || !is_met(floor, limit, *value)) return report;
  condition.value = limit;  // It is missed by rounding alone.
  return judge(condition);
}

}  // namespace

std::vector<ConstraintReport> floor_constraints(const Problem& problem,
                                                const DesignReport& report) {
  std::vector<ConstraintReport> list;
  for (const FloorRecord& floor : kFloors) {
    const auto& limit = problem.floors.*floor.limit;
    if (!limit) continue;
    list.push_back(floor_constraint(floor, *limit, value_of(floor.quantity, problem, report)));
  }
  return list;
}

void add_floors(const Problem& problem, const FloorGoals& goals, optimization::Problem& model) {
  for (const FloorRecord& floor : kFloors) {
    const auto& limit = problem.floors.*floor.limit;
    if (!limit) continue;
    Goal goal = goal_of(floor.quantity, problem, goals);
    // Where any ratio will do, what is known of it encloses nothing.
    if (problem.ratio_tolerance > 1) goal.enclosure.reset();
    const Expression met(met_from(floor, *limit));
    const std::string name(floor.name);
    const auto add = [&](const Expression& value) {
      model.conditions.push_back(
          {name, name, std::string(floor.key), floor.is_ceiling ? met - value : value - met});
    };
    add(goal.value);
    if (goal.enclosure) add(*goal.enclosure);  // It decides no point, but boxes sooner.
    model.loosenings.push_back({std::string(floor.key), std::move(goal)});
  }
}

Goal backlash_goal(const Rational& module_mm, const Expression& teeth) {
  const Expression cosine = cos(Expression::pi() / 9.0);
  return {"backlash", "rad/mm", 4.0 / (Expression(module_mm) * cosine * teeth)};
}

}  // namespace torquewright::gearbox
