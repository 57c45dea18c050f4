// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/planetary_model.hpp"

#include <array>
#include <stdexcept>

#include "gearbox/constraints/buildable.hpp"
#include "gearbox/constraints/floors.hpp"
#include "gearbox/constraints/goals.hpp"
#include "gearbox/constraints/tooth_conditions.hpp"
#include "gearbox/train/efficiency.hpp"
#include "gearbox/train/inertia.hpp"
#include "gearbox/train/mass.hpp"

namespace torquewright::gearbox::planetary {
namespace {

using optimization::Goal;
using optimization::Loosening;
using optimization::Predicate;
using Teeth = PlanetaryTeeth<Expression>;
using Point = std::span<const std::int64_t>;

Teeth variables() {
  return coaxial_planetary<Expression>(Expression::variable(0), Expression::variable(1));
}

// i = 2 (S + P)/S: linear once multiplied by S.
std::vector<Condition> ratio_conditions(const Problem& problem, const Teeth& teeth) {
  const Expression turned = 2.0 * teeth.sun + 2.0 * teeth.planet;
  return {{"ratio_max", "ratio", "/ratio_tolerance",
           Expression(greatest_ratio(problem)) * teeth.sun - turned},
          {"ratio_min", "ratio", "/ratio_tolerance",
           turned - Expression(least_ratio(problem)) * teeth.sun}};
}

std::vector<Condition> conditions(const Problem& problem, std::int64_t planet_count,
                                  const Rational& module_mm, const Teeth& teeth) {
  std::vector<Condition> result = ratio_conditions(problem, teeth);
  const auto add = [&](const std::vector<Condition>& more) {
    result.insert(result.end(), more.begin(), more.end());
  };
  add({at_least("sun", teeth.sun, problem.min_teeth.at("sun")),
       at_least("planet", teeth.planet, problem.min_teeth.at("planet")),
       carrier_clearance(problem, planet_count, teeth.sun, teeth.planet),
       rotor_bore(problem, module_mm, teeth.ring)});
  const std::array all{teeth.sun, teeth.planet, teeth.ring};
  add(buildable_conditions(problem, train_parts(problem.topology), planet_count, module_mm, all,
                           {}));
  return result;
}

Goal efficiency(const Problem& problem, const Teeth& teeth, bool forward) {
  const auto mesh = mesh_efficiencies(teeth, io::nearest(*problem.friction_coefficient));
  const Expression ratio = teeth.ring / teeth.sun;
  return {forward ? "forward_efficiency" : "backward_efficiency", "",
          min(forward ? planetary_forward_efficiency(ratio, mesh)
                      : planetary_backward_efficiency(ratio, mesh),
              1.0),
          /*maximise=*/true};
}

Goal goal_of(Objective objective, const Problem& problem, std::int64_t planet_count,
             const Rational& module_mm, const Teeth& teeth) {
  switch (objective) {
    case Objective::kHollowShaft:
      return hollow_shaft(problem, module_mm, teeth.sun);
    case Objective::kForwardEfficiency:
      return efficiency(problem, teeth, true);
    case Objective::kBackwardEfficiency:
      return efficiency(problem, teeth, false);
    case Objective::kMass:
      return mass_goal(planetary_mass_kg(blank(problem, module_mm), planet_count, teeth));
    case Objective::kReflectedInertia:
      return inertia_goal(reflected_inertia_kg_m2(
          planetary_reduction(teeth),
          planetary_inertia_at_sun_kg_m2(blank(problem, module_mm),
                                         io::nearest(problem.rotor_inertia_kg_m2), planet_count,
                                         teeth)));
    case Objective::kPaperCost:
      break;  // refused by the reader: the paper's cost needs five gears
  }
  throw std::logic_error("unknown objective");
}

std::vector<Loosening> loosenings(const Problem& problem, std::int64_t planet_count,
                                  const Rational& module_mm, const Teeth& teeth) {
  std::vector<Loosening> result{
      most_teeth("sun", teeth.sun),
      most_teeth("planet", teeth.planet),
      most_carrier_clearance(planet_count, teeth.sun, teeth.planet),
      least_blank(problem, module_mm, teeth.ring),
      least_ratio_error(problem, 2.0 * (teeth.sun + teeth.planet) / teeth.sun),
      most_neighbour_clearance(
          neighbour_clearance_mm(planet_count, module_mm, teeth.sun + teeth.planet, teeth.planet)),
      most_contact(min(contact_ratio(external_path(teeth.sun, teeth.planet)),
                       contact_ratio(internal_path(teeth.planet, teeth.ring))))};
  if (problem.ring_outer_diameter_mm) result.push_back(least_ring(module_mm, teeth.ring));
  return result;
}

}  // namespace

optimization::Problem model(const Problem& problem, std::int64_t planet_count,
                            const Rational& module_mm, std::int64_t ring_limit) {
  const Teeth teeth = variables();
  optimization::Problem result{
      {"sun", "planet"},
      {{1, ring_limit}, {1, ring_limit / 2}},
      conditions(problem, planet_count, module_mm, teeth),
      {{"equal_spacing", "",
        [planet_count](Point point) { return 2 * (point[0] + point[1]) % planet_count == 0; }}},
      goal_of(problem.objective, problem, planet_count, module_mm, teeth),
      loosenings(problem, planet_count, module_mm, teeth)};
  const auto objective_goal = [&](Objective objective) {
    return goal_of(objective, problem, planet_count, module_mm, teeth);
  };
  add_floors(problem, {objective_goal, backlash_goal(module_mm, teeth.sun + teeth.ring)}, result);
  return result;
}

std::vector<std::int64_t> free_teeth(std::span<const std::int64_t> point) {
  return {point.begin(), point.end()};
}

std::vector<std::int64_t> point_of(std::span<const std::int64_t> free_teeth) {
  return {free_teeth.begin(), free_teeth.end()};
}

}  // namespace torquewright::gearbox::planetary
