// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/three_k_model.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "gearbox/constraints/buildable.hpp"
#include "gearbox/constraints/floors.hpp"
#include "gearbox/constraints/goals.hpp"
#include "gearbox/constraints/tooth_conditions.hpp"
#include "gearbox/train/assembly.hpp"
#include "gearbox/train/efficiency.hpp"
#include "gearbox/train/inertia.hpp"
#include "gearbox/train/mass.hpp"

namespace torquewright::gearbox::three_k {
namespace {

using optimization::Direction;
using optimization::Goal;
using optimization::Loosening;
using optimization::Predicate;
using Teeth = ThreeKTeeth<Expression>;
using Point = std::span<const std::int64_t>;

// The variables: S, P1 and d = P1 - P2. In these, and not in S, P1, P2, the ratio is monotone.
struct Variables {
  Expression sun = Expression::variable(0);
  Expression planet_1 = Expression::variable(1);
  Expression difference = Expression::variable(2);
};

Teeth teeth_of(const Variables& x) {
  return coaxial_three_k<Expression>(x.sun, x.planet_1, x.planet_1 - x.difference);
}

ThreeKTeeth<std::int64_t> teeth_at(Point point) {
  const std::int64_t planet_2 = point[1] - point[2];
  return {point[0], point[1], planet_2, point[0] + 2 * point[1], point[0] + point[1] + planet_2};
}

// The difference at which the ratio is exactly G: 2 P1 (S + 2 P1)/(G S + 2 P1), written as
// (2/G) P1 + 4 (G-1)/G P1^2/(G S + 2 P1): a square over a linear form, which is convex for G >= 1.
// It grows with P1 and, for G >= 1, falls with S. docs/certificate.md, "The tree".
Expression difference_for(const Rational& ratio, const Variables& x) {
  const Rational c = 4 * (ratio - 1) / ratio;
  return Expression(2 / ratio) * x.planet_1 +
         Expression(c) * square_over(x.planet_1, Expression(ratio) * x.sun + 2.0 * x.planet_1);
}

// The ratio falls as the difference grows.
std::vector<Condition> ratio_conditions(const Problem& problem, const Variables& x) {
  using enum Direction;
  Condition greatest{"ratio_max", "ratio", "/ratio_tolerance",
                     x.difference - difference_for(greatest_ratio(problem), x)};
  greatest.directions = {greatest_ratio(problem) >= 1 ? kGrows : kUnknown, kFalls, kGrows};
  Condition least{"ratio_min", "ratio", "/ratio_tolerance",
                  difference_for(least_ratio(problem), x) - x.difference};
  least.directions = {least_ratio(problem) >= 1 ? kFalls : kUnknown, kGrows, kFalls};
  return {greatest, least};
}

void add_paper_conditions(const Problem& problem, std::int64_t planet_count,
                          const Rational& module_mm, const Variables& x,
                          std::vector<Condition>& conditions) {
  const Teeth teeth = teeth_of(x);
  conditions.push_back({"positive_teeth", "positive_teeth", "", teeth.planet_2 - 1.0});
  for (const Condition& condition : ratio_conditions(problem, x)) conditions.push_back(condition);
  conditions.push_back(at_least("sun", teeth.sun, problem.min_teeth.at("sun")));
  conditions.push_back(at_least("planet_1", teeth.planet_1, problem.min_teeth.at("planet_1")));
  conditions.push_back(at_least("planet_2", teeth.planet_2, problem.min_teeth.at("planet_2")));
  conditions.push_back(carrier_clearance(problem, planet_count, teeth.sun, teeth.planet_1));
  conditions.push_back(rotor_bore(problem, module_mm, teeth.fixed_ring));
  conditions.push_back({"tooth_difference", "tooth_difference", "",
                        x.difference - static_cast<double>(planet_count)});
}

void add_buildable_conditions(const Problem& problem, std::int64_t planet_count,
                              const Rational& module_mm, const Variables& x,
                              std::vector<Condition>& conditions) {
  const Teeth teeth = teeth_of(x);
  std::vector<Condition> own;
  if (problem.sun_under_second_layer) {
    own.push_back({"sun_under_layer_2", "sun_under_layer_2", "",
                   Expression(module_mm) * (x.difference / 2.0 - 2.0), /*strict=*/true});
  }
  const std::array all{teeth.sun, teeth.planet_1, teeth.planet_2, teeth.fixed_ring,
                       teeth.output_ring};
  for (Condition& condition : buildable_conditions(problem, train_parts(problem.topology),
                                                   planet_count, module_mm, all, own)) {
    conditions.push_back(std::move(condition));
  }
}

std::vector<Predicate> predicates(const Problem& problem, std::int64_t planet_count) {
  std::vector<Predicate> result{{"equal_spacing", "", [planet_count](Point point) {
                                   return 2 * (point[0] + point[1]) % planet_count == 0;
                                 }}};
  if (problem.constraints == ConstraintSet::kBuildable) {
    result.push_back({"identical_planets", "", [planet_count](Point point) {
                        return has_identical_planets(teeth_at(point), planet_count);
                      }});
  }
  return result;
}

Goal paper_cost(const Problem& problem, const Rational& module_mm, const Teeth& teeth) {
  const Expression bore{Rational(problem.rotor_inner_diameter_mm / module_mm)};
  return {"paper_cost", "",
          1.0 / square(teeth.sun) + square(teeth.fixed_ring - bore) + square(teeth.planet_1) +
              square(teeth.planet_2) + square(teeth.output_ring),
          /*maximise=*/false, /*exact=*/true};
}

// A box may reach where planet 2 has no teeth. Nothing feasible lies there, and there may be no
// finite bound: for enclosures it has one tooth at least.
Teeth teeth_with_planet_2(const Variables& x) {
  return coaxial_three_k<Expression>(x.sun, x.planet_1, max(x.planet_1 - x.difference, 1.0));
}

Expression allowed_ratio(const Problem& problem) {
  return Expression::between(least_ratio(problem), greatest_ratio(problem));
}

// 1 where power passes every mesh, else 0: the rings' tips lie outside their base circles, and
// friction leaves something. With such rings every contact ratio exceeds 1. The ramp between is far
// narrower than the margins are at whole teeth. docs/derivations/efficiency.md, "What transmits
// nothing".
Expression transmission(const Teeth& teeth, const ThreeKMeshEfficiencies<Expression>& mesh) {
  constexpr double kSteep = 0x1p40;
  const Expression tips =
      min(ring_tip_margin(teeth.fixed_ring), ring_tip_margin(teeth.output_ring));
  const Expression left =
      min(mesh.sun_planet_1, min(mesh.planet_1_fixed_ring, mesh.planet_2_output_ring));
  return min(max(kSteep * min(tips, left), 0.0), 1.0);
}

// With 1/(1 - I2) = i/(1 + I1) the efficiencies need the ratio i, known within its tolerance, in
// place of I2: the enclosure stays narrow on wide boxes. docs/derivations/efficiency.md.
Expression enclosed_efficiency(const Problem& problem, const Variables& x, bool forward) {
  const Teeth teeth = teeth_with_planet_2(x);
  const auto mesh = mesh_efficiencies(teeth, io::nearest(*problem.friction_coefficient));
  const Expression first = mesh.sun_planet_1 * mesh.planet_1_fixed_ring;
  const Expression second = mesh.planet_1_fixed_ring * mesh.planet_2_output_ring;
  const Expression carrier = 1.0 / (1.0 + basic_ratio_1(teeth));  // 1/(1 + I1)
  const Expression stepped = allowed_ratio(problem) * carrier;    // 1/(1 - I2)
  if (forward) {
    return (carrier + first * (1.0 - carrier)) / (1.0 + (1.0 - second) * (stepped - 1.0));
  }
  // (eta_b eta_c - I2)/(1 - I2) = 1 - (1 - eta_b eta_c)/(1 - I2)
  return mesh.sun_planet_1 * (1.0 - (1.0 - second) * stepped) /
         (mesh.planet_2_output_ring * (1.0 - carrier + first * carrier));
}

Goal efficiency(const Problem& problem, const Variables& x, bool forward) {
  const Teeth teeth = teeth_of(x);
  const double friction = io::nearest(*problem.friction_coefficient);
  const auto mesh = mesh_efficiencies(teeth, friction);
  const Expression i1 = basic_ratio_1(teeth), i2 = basic_ratio_2(teeth);
  const auto transmitted = [&](const Teeth& gears, const Expression& value) {
    // Buildable gears have at least 18 teeth, and rings with their tips outside their base circles.
    if (problem.constraints == ConstraintSet::kBuildable) return max(value, 0.0);
    return max(transmission(gears, mesh_efficiencies(gears, friction)) * value, 0.0);
  };
  Goal goal{forward ? "forward_efficiency" : "backward_efficiency", "",
            transmitted(teeth, forward ? three_k_forward_efficiency(i1, i2, mesh)
                                       : three_k_backward_efficiency(i1, i2, mesh)),
            /*maximise=*/true};
  goal.enclosure =
      min(transmitted(teeth_with_planet_2(x), enclosed_efficiency(problem, x, forward)), 1.0);
  return goal;
}

// As with the efficiencies, the ratio is known better than its formula's enclosure tells.
Goal inertia(const Problem& problem, std::int64_t planet_count, const Rational& module_mm,
             const Variables& x) {
  const Blank bodies = blank(problem, module_mm);
  const double rotor_kg_m2 = io::nearest(problem.rotor_inertia_kg_m2);
  const Teeth teeth = teeth_of(x), enclosing = teeth_with_planet_2(x);
  Goal goal = inertia_goal(reflected_inertia_kg_m2(
      three_k_reduction(teeth),
      three_k_inertia_at_sun_kg_m2(bodies, rotor_kg_m2, planet_count, teeth)));
  goal.enclosure = reflected_inertia_kg_m2(
                       allowed_ratio(problem),
                       three_k_input_inertia_kg_m2(bodies, rotor_kg_m2, planet_count, enclosing)) +
                   ring_inertia_kg_m2(bodies, bodies.face_width_2_m, enclosing.output_ring);
  return goal;
}

Goal goal_of(Objective objective, const Problem& problem, std::int64_t planet_count,
             const Rational& module_mm, const Variables& x) {
  const Teeth teeth = teeth_of(x);
  switch (objective) {
    case Objective::kPaperCost:
      return paper_cost(problem, module_mm, teeth);
    case Objective::kHollowShaft:
      return hollow_shaft(problem, module_mm, teeth.sun);
    case Objective::kForwardEfficiency:
      return efficiency(problem, x, true);
    case Objective::kBackwardEfficiency:
      return efficiency(problem, x, false);
    case Objective::kMass:
      return mass_goal(three_k_mass_kg(blank(problem, module_mm), planet_count, teeth));
    case Objective::kReflectedInertia:
      return inertia(problem, planet_count, module_mm, x);
  }
  throw std::logic_error("unknown objective");
}

std::vector<Loosening> loosenings(const Problem& problem, std::int64_t planet_count,
                                  const Rational& module_mm, const Variables& x) {
  const Teeth teeth = teeth_of(x);
  const Expression ratio = 2.0 * x.planet_1 * teeth.output_ring / (x.sun * x.difference);
  std::vector<Loosening> result{most_teeth("sun", teeth.sun),
                                most_teeth("planet_1", teeth.planet_1),
                                most_teeth("planet_2", teeth.planet_2),
                                most_carrier_clearance(planet_count, teeth.sun, teeth.planet_1),
                                least_ratio_error(problem, ratio)};
  const bool is_walled = problem.constraints == ConstraintSet::kBuildable;
  if (!is_walled || problem.ring_outer_diameter_mm) {
    result.push_back(least_ring(module_mm, teeth.fixed_ring));
  }
  if (!is_walled) return result;
  const auto clearance = [&](const Expression& planet) {
    return neighbour_clearance_mm(planet_count, module_mm, teeth.sun + teeth.planet_1, planet);
  };
  result.push_back(
      most_neighbour_clearance(min(clearance(teeth.planet_1), clearance(teeth.planet_2))));
  result.push_back(
      most_contact(min(contact_ratio(external_path(teeth.sun, teeth.planet_1)),
                       min(contact_ratio(internal_path(teeth.planet_1, teeth.fixed_ring)),
                           contact_ratio(internal_path(teeth.planet_2, teeth.output_ring))))));
  result.push_back(least_blank(problem, module_mm, teeth.fixed_ring));
  return result;
}

}  // namespace

optimization::Problem model(const Problem& problem, std::int64_t planet_count,
                            const Rational& module_mm, std::int64_t ring_limit) {
  const Variables x;
  optimization::Problem result{{"sun", "planet_1", "difference"},
                               {{1, ring_limit}, {1, ring_limit / 2}, {1, ring_limit / 2}},
                               {},
                               predicates(problem, planet_count),
                               goal_of(problem.objective, problem, planet_count, module_mm, x),
                               loosenings(problem, planet_count, module_mm, x)};
  add_paper_conditions(problem, planet_count, module_mm, x, result.conditions);
  if (problem.constraints == ConstraintSet::kBuildable) {
    add_buildable_conditions(problem, planet_count, module_mm, x, result.conditions);
  }
  const auto objective_goal = [&](Objective objective) {
    return goal_of(objective, problem, planet_count, module_mm, x);
  };
  add_floors(problem, {objective_goal, backlash_goal(module_mm, teeth_of(x).output_ring)}, result);
  return result;
}

std::vector<std::int64_t> free_teeth(std::span<const std::int64_t> point) {
  return {point[0], point[1], point[1] - point[2]};
}

std::vector<std::int64_t> point_of(std::span<const std::int64_t> free_teeth) {
  return {free_teeth[0], free_teeth[1], free_teeth[1] - free_teeth[2]};
}

}  // namespace torquewright::gearbox::three_k
