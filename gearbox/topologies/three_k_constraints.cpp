// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "gearbox/constraints/buildable.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/topologies/shifted_train.hpp"
#include "gearbox/topologies/three_k_design.hpp"

namespace torquewright::gearbox::three_k {

namespace {

PlanetCircle circle_of(const ThreeKDesign& design) {
  return {design.teeth.sun, design.teeth.planet_1, design.planet_count, design.module_mm};
}

}  // namespace

std::vector<ConstraintReport> paper_constraints(const ThreeKDesign& design) {
  const Problem& problem = design.problem;
  const ThreeKTeeth<std::int64_t>& teeth = design.teeth;
  const bool exists = !design.stands_still();
  const Rational reduction =
      exists ? three_k_reduction<Rational>(
                   {teeth.sun, teeth.planet_1, teeth.planet_2, teeth.fixed_ring, teeth.output_ring})
             : Rational(0);
  return {ratio_window(problem, reduction, exists),
          minimum_teeth(problem, "sun", teeth.sun),
          minimum_teeth(problem, "planet_1", teeth.planet_1),
          minimum_teeth(problem, "planet_2", teeth.planet_2),
          carrier_clearance(circle_of(design), problem.min_carrier_clearance_rad),
          rotor_bore(problem, design.module_mm, teeth.fixed_ring),
          tooth_difference(teeth.planet_1, teeth.planet_2, design.planet_count),
          equal_spacing(teeth.sun, teeth.fixed_ring, design.planet_count)};
}

std::vector<ConstraintReport> further_constraints(const ThreeKDesign& design) {
  const ThreeKTeeth<std::int64_t>& z = design.teeth;
  std::vector<ConstraintReport> list{identical_planets(z, design.planet_count)};
  std::vector<ConstraintReport> own;
  if (design.problem.sun_under_second_layer) {
    own.push_back(sun_under_layer_2(design.module_mm, z.planet_1, z.planet_2));
  }
  const Design plain{{z.sun, z.planet_1, z.planet_2, z.fixed_ring, z.output_ring},
                     design.planet_count,
                     design.module_mm};
  for (ConstraintReport& report :
       design.cut ? shifted_conditions(design.problem, *design.cut)
                  : buildable_constraints(design.problem, train_parts(design.problem.topology),
                                          plain, own)) {
    list.push_back(std::move(report));
  }
  return list;
}

std::vector<ConstraintReport> coaxiality_constraints(const ThreeKDesign& design) {
  if (design.cut) return shifted_coaxiality(*design.cut);
  const ThreeKTeeth<std::int64_t>& teeth = design.teeth;
  const std::int64_t centres = teeth.sun + teeth.planet_1;
  if (teeth.fixed_ring == centres + teeth.planet_1 &&
      teeth.output_ring == centres + teeth.planet_2) {
    return {};
  }
  return {coaxiality("fixed_ring", teeth.planet_1, teeth.fixed_ring, centres),
          coaxiality("output_ring", teeth.planet_2, teeth.output_ring, centres)};
}

}  // namespace torquewright::gearbox::three_k
