// SPDX-License-Identifier: Apache-2.0
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {

Rational ring_wall_mm(const Problem& problem, const Rational& module_mm) {
  return problem.ring_wall_mm ? *problem.ring_wall_mm : Rational(Rational(9, 4) * module_mm);
}

Rational hollow_shaft_wall_mm(const Problem& problem, const Rational& module_mm) {
  return problem.hollow_shaft_wall_mm ? *problem.hollow_shaft_wall_mm
                                      : ring_wall_mm(problem, module_mm);
}

Rational ring_blank_mm(const Problem& problem, const Rational& module_mm, const Rational& teeth) {
  return module_mm * (teeth + 2 * problem.cutters.shaper_depth()) +
         2 * ring_wall_mm(problem, module_mm);
}

Rational ring_space_mm(const Problem& problem) {
  return problem.ring_outer_diameter_mm.value_or(problem.rotor_inner_diameter_mm);
}

std::string ring_space_key(const Problem& problem) {
  return problem.ring_outer_diameter_mm ? "/ring_outer_diameter_mm" : "/rotor_inner_diameter_mm";
}

}  // namespace torquewright::gearbox
