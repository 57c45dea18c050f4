// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/goals.hpp"

#include "gearbox/constraints/tooth_conditions.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {

using optimization::Expression;
using optimization::Goal;
using optimization::Loosening;

Blank blank(const Problem& problem, const Rational& module_mm) {
  const auto width_m = [&](const char* layer) {
    const auto found = problem.face_width_mm.find(layer);
    return found == problem.face_width_mm.end() ? 0.0 : io::nearest(found->second) / 1000.0;
  };
  return {io::nearest(module_mm) / 1000.0,
          io::nearest(problem.density_kg_m3.value_or(0)),
          width_m("layer_1"),
          width_m("layer_2"),
          io::nearest(ring_wall_mm(problem, module_mm)) / 1000.0,
          io::nearest(problem.cutters.hob_depth()),
          io::nearest(problem.cutters.shaper_depth())};
}

Goal hollow_shaft(const Problem& problem, const Rational& module_mm, const Expression& sun) {
  const Rational walls_mm = 2 * hollow_shaft_wall_mm(problem, module_mm);
  return {"hollow_shaft", "mm",
          Expression(module_mm) * (sun - Expression(Rational(2 * problem.cutters.hob_depth()))) -
              Expression(walls_mm),
          /*maximise=*/true, /*exact=*/true};
}

Goal mass_goal(const Expression& mass_kg) { return {"mass", "kg", mass_kg}; }
Goal inertia_goal(const Expression& inertia_kg_m2) {
  return {"reflected_inertia", "kg m^2", inertia_kg_m2};
}

Loosening most_teeth(const std::string& gear, const Expression& teeth) {
  return {"/min_teeth/" + gear, {"teeth." + gear, "teeth", teeth, true, true}};
}

Loosening most_carrier_clearance(std::int64_t planet_count, const Expression& sun,
                                 const Expression& planet) {
  return {"/min_carrier_clearance_rad",
          {"carrier_clearance", "rad", carrier_clearance_rad(planet_count, sun, planet), true}};
}

Loosening least_ring(const Rational& module_mm, const Expression& ring) {
  return {"/rotor_inner_diameter_mm",
          {"ring_pitch_diameter_mm", "mm", Expression(module_mm) * ring, false, true}};
}

Loosening least_ratio_error(const Problem& problem, const Expression& ratio) {
  return {"/ratio_tolerance",
          {"ratio_error", "", abs(ratio / Expression(problem.target_ratio) - 1.0), false, true}};
}

Loosening most_neighbour_clearance(const Expression& clearance_mm) {
  return {"/min_neighbour_clearance_mm", {"neighbour_clearance_mm", "mm", clearance_mm, true}};
}

Loosening most_contact(const Expression& contact_ratio) {
  return {"/min_contact_ratio", {"contact_ratio", "", contact_ratio, true}};
}

Loosening least_blank(const Problem& problem, const Rational& module_mm, const Expression& ring) {
  const Rational walls_mm = 2 * ring_wall_mm(problem, module_mm);
  return {
      ring_space_key(problem),
      {"ring_blank_diameter_mm", "mm",
       Expression(module_mm) * (ring + Expression(Rational(2 * problem.cutters.shaper_depth()))) +
           Expression(walls_mm),
       false, true}};
}

}  // namespace torquewright::gearbox
