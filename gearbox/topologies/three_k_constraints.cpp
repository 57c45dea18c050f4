// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/root_form.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/topologies/shifted_train.hpp"
#include "gearbox/topologies/three_k_design.hpp"

namespace torquewright::gearbox::three_k {

namespace {

constexpr const char* kFixedMesh = "planet_1_fixed_ring";
constexpr const char* kOutputMesh = "planet_2_output_ring";

PlanetCircle circle_of(const ThreeKDesign& design) {
  return {design.teeth.sun, design.teeth.planet_1, design.planet_count, design.module_mm};
}

void append_ring_constraints(const ThreeKDesign& design, std::vector<ConstraintReport>& list) {
  const ThreeKTeeth<std::int64_t>& teeth = design.teeth;
  list.push_back(ring_wall(design.problem, design.module_mm, "fixed_ring", teeth.fixed_ring));
  list.push_back(ring_wall(design.problem, design.module_mm, "output_ring", teeth.output_ring));
  list.push_back(ring_tip(design.module_mm, "fixed_ring", teeth.fixed_ring));
  list.push_back(ring_tip(design.module_mm, "output_ring", teeth.output_ring));
}

void append_root_forms(const ThreeKDesign& design, std::vector<ConstraintReport>& list) {
  const Problem& problem = design.problem;
  const ThreeKTeeth<std::int64_t>& z = design.teeth;
  const Rational& module_mm = design.module_mm;
  list.push_back(root_form_of_gears(problem, module_mm, "sun_planet_1", z.sun, z.planet_1));
  list.push_back(root_form_of_planet(problem, module_mm, kFixedMesh, z.fixed_ring));
  list.push_back(root_form_of_planet(problem, module_mm, kOutputMesh, z.output_ring));
  list.push_back(root_form_of_ring(problem, module_mm, kFixedMesh, z.planet_1, z.fixed_ring));
  list.push_back(root_form_of_ring(problem, module_mm, kOutputMesh, z.planet_2, z.output_ring));
  if (!problem.cutters.shaper_teeth) return;
  list.push_back(shaper_feed(problem, kFixedMesh, z.fixed_ring));
  list.push_back(shaper_feed(problem, kOutputMesh, z.output_ring));
}

void append_mesh_constraints(const ThreeKDesign& design, std::vector<ConstraintReport>& list) {
  const Problem& problem = design.problem;
  const ThreeKTeeth<std::int64_t>& teeth = design.teeth;
  list.push_back(involute_interference(kFixedMesh, teeth.planet_1, teeth.fixed_ring));
  list.push_back(involute_interference(kOutputMesh, teeth.planet_2, teeth.output_ring));
  list.push_back(trochoid_interference(kFixedMesh, teeth.planet_1, teeth.fixed_ring));
  list.push_back(trochoid_interference(kOutputMesh, teeth.planet_2, teeth.output_ring));
  list.push_back(contact_ratio_limit(problem, "sun_planet_1", MeshKind::kExternal,
                                     external_path_of(teeth.sun, teeth.planet_1)));
  list.push_back(contact_ratio_limit(problem, kFixedMesh, MeshKind::kInternal,
                                     internal_path_of(teeth.planet_1, teeth.fixed_ring)));
  list.push_back(contact_ratio_limit(problem, kOutputMesh, MeshKind::kInternal,
                                     internal_path_of(teeth.planet_2, teeth.output_ring)));
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
  const ThreeKTeeth<std::int64_t>& teeth = design.teeth;
  const Rational& minimum_mm = design.problem.min_neighbour_clearance_mm;
  if (design.cut) {
    std::vector<ConstraintReport> list{identical_planets(teeth, design.planet_count)};
    for (ConstraintReport& report : shifted_conditions(design.problem, *design.cut)) {
      list.push_back(std::move(report));
    }
    return list;
  }
  std::vector<ConstraintReport> list{
      identical_planets(teeth, design.planet_count),
      neighbour_clearance(circle_of(design), "layer_1", teeth.planet_1, minimum_mm),
      neighbour_clearance(circle_of(design), "layer_2", teeth.planet_2, minimum_mm),
      undercut(design.problem, "sun", teeth.sun),
      undercut(design.problem, "planet_1", teeth.planet_1),
      undercut(design.problem, "planet_2", teeth.planet_2)};
  if (design.problem.sun_under_second_layer) {
    list.push_back(sun_under_layer_2(design.module_mm, teeth.planet_1, teeth.planet_2));
  }
  append_ring_constraints(design, list);
  append_mesh_constraints(design, list);
  append_root_forms(design, list);
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
