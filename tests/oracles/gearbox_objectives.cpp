// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/gearbox_objectives.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/oracles/involute_meshes.hpp"
#include "tests/oracles/reals.hpp"
#include "tests/oracles/rule_families.hpp"

namespace torquewright::oracles {
namespace {

Rational hollow_shaft_mm(const Setting& setting, const Teeth& teeth) {
  const gearbox::Problem& problem = setting.problem;
  const Rational rim = problem.ring_wall_mm.value_or(Rational(9, 4) * setting.module_mm);
  return setting.module_mm *
             (teeth.sun - 2 * problem.cutters.hob_addendum.value_or(Rational(5, 4))) -
         2 * problem.hollow_shaft_wall_mm.value_or(rim);
}

long double paper_cost_rounded(const Setting& setting, const Teeth& teeth) {
  const long double bore =
      to_long_double(setting.problem.rotor_inner_diameter_mm / setting.module_mm);
  const auto square = [](long double x) { return x * x; };
  return 1 / square(real(teeth.sun)) + square(real(teeth.fixed_ring) - bore) +
         square(real(teeth.planet_1)) + square(real(teeth.planet_2)) +
         square(real(teeth.output_ring));
}

Efficiencies of_3k(const Teeth& teeth, long double a, long double b, long double c) {
  const long double i1 = real(teeth.fixed_ring) / real(teeth.sun);
  const long double i2 = real(teeth.fixed_ring) * real(teeth.planet_2) /
                         (real(teeth.planet_1) * real(teeth.output_ring));
  // The branches differ by the direction in which the output turns.
  if (i2 < 1) {
    return {(1 + a * b * i1) * (1 - i2) / ((1 + i1) * (1 - b * c * i2)),
            a * (1 + i1) * (b * c - i2) / (c * (a * b + i1) * (1 - i2))};
  }
  return {c * (b + a * i1) * (i2 - 1) / ((1 + i1) * (i2 - b * c)),
          a * (1 + i1) * (b * c * i2 - 1) / ((a + b * i1) * (i2 - 1))};
}

Efficiencies of_planetary(const Teeth& teeth, long double a, long double b) {
  const long double i = real(teeth.fixed_ring) / real(teeth.sun);
  return {(1 + a * b * i) / (1 + i), (1 + i) / (1 + i / (a * b))};
}

struct Mesh {
  bool transmits;
  long double efficiency;
};

Mesh mesh(const ContactPath& path, long double efficiency) {
  // What is not a number does not compare.
  return {path.ratio() >= 1 && efficiency > 0, efficiency};
}

Mesh sun_mesh(const Teeth& teeth, long double friction) {
  return mesh(external_path(teeth.sun, teeth.planet_1),
              external_efficiency(teeth.sun, teeth.planet_1, friction));
}

Mesh ring_mesh(std::int64_t planet, std::int64_t ring, long double friction) {
  return mesh(internal_path(planet, ring), internal_efficiency(planet, ring, friction));
}

}  // namespace

bool greater_is_better(gearbox::Objective objective) {
  switch (objective) {
    case gearbox::Objective::kPaperCost:
    case gearbox::Objective::kMass:
    case gearbox::Objective::kReflectedInertia:
      return false;
    case gearbox::Objective::kHollowShaft:
    case gearbox::Objective::kForwardEfficiency:
    case gearbox::Objective::kBackwardEfficiency:
      return true;
  }
  throw std::invalid_argument("unknown objective");
}

Rational paper_cost(const Setting& setting, const Teeth& teeth) {
  const Rational over =
      teeth.fixed_ring - setting.problem.rotor_inner_diameter_mm / setting.module_mm;
  return Rational(1, teeth.sun * teeth.sun) + over * over +
         Rational(teeth.planet_1 * teeth.planet_1 + teeth.planet_2 * teeth.planet_2 +
                  teeth.output_ring * teeth.output_ring);
}

std::optional<Rational> exact_objective(const Setting& setting, const Teeth& teeth) {
  switch (setting.problem.objective) {
    case gearbox::Objective::kPaperCost:
      return paper_cost(setting, teeth);
    case gearbox::Objective::kHollowShaft:
      return hollow_shaft_mm(setting, teeth);
    default:
      return std::nullopt;
  }
}

Efficiencies efficiencies(bool three_k, const Teeth& teeth, long double sun_mesh,
                          long double fixed_mesh, long double output_mesh) {
  return three_k ? of_3k(teeth, sun_mesh, fixed_mesh, output_mesh)
                 : of_planetary(teeth, sun_mesh, fixed_mesh);
}

Efficiencies efficiencies(const gearbox::Problem& problem, const Teeth& teeth) {
  const long double friction = to_long_double(problem.friction_coefficient.value());
  const bool three_k = is_3k(problem);
  const Mesh sun = sun_mesh(teeth, friction);
  const Mesh fixed = ring_mesh(teeth.planet_1, teeth.fixed_ring, friction);
  const Mesh output =
      three_k ? ring_mesh(teeth.planet_2, teeth.output_ring, friction) : Mesh{true, 1};
  if (!sun.transmits || !fixed.transmits || !output.transmits) return {0, 0};
  return efficiencies(three_k, teeth, sun.efficiency, fixed.efficiency, output.efficiency);
}

long double objective_value(const Setting& setting, const Teeth& teeth) {
  switch (setting.problem.objective) {
    case gearbox::Objective::kPaperCost:
      return paper_cost_rounded(setting, teeth);
    case gearbox::Objective::kMass:
      return mass_kg(setting, teeth);
    case gearbox::Objective::kHollowShaft:
      return to_long_double(hollow_shaft_mm(setting, teeth));
    case gearbox::Objective::kForwardEfficiency:
      return efficiencies(setting.problem, teeth).forward;
    case gearbox::Objective::kBackwardEfficiency:
      // A train that locks itself transmits nothing backwards.
      return std::max(0.0L, efficiencies(setting.problem, teeth).backward);
    case gearbox::Objective::kReflectedInertia:
      return reflected_inertia_kg_m2(setting, teeth);
  }
  throw std::invalid_argument("unknown objective");
}

}  // namespace torquewright::oracles
