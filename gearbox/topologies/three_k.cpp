// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/three_k.hpp"

#include <algorithm>
#include <cmath>

#include "gearbox/constraints/floors.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/topologies/report_parts.hpp"
#include "gearbox/topologies/shifted_train.hpp"
#include "gearbox/topologies/three_k_design.hpp"
#include "gearbox/topologies/three_k_model.hpp"
#include "gearbox/train/assembly.hpp"
#include "gearbox/train/backlash.hpp"
#include "gearbox/train/inertia.hpp"
#include "gearbox/train/loads.hpp"
#include "gearbox/train/power_flow.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox::three_k {

namespace {

/// Each gear's own radius, pitch or base, in millimetres.
ThreeKRadii radii_mm(const ThreeKTeeth<double>& teeth, double radius_per_tooth_mm) {
  return {radius_per_tooth_mm * teeth.sun, radius_per_tooth_mm * teeth.fixed_ring,
          radius_per_tooth_mm * teeth.output_ring};
}

void describe_gears(const ThreeKDesign& design, DesignReport& report) {
  const ThreeKTeeth<double> teeth = design.real_teeth();
  const Rational& module = design.module_mm;
  const StatedCutters& cutters = design.problem.cutters;
  const double planet = planet_speed_per_sun(teeth.sun, teeth.planet_1, teeth.fixed_ring);
  const double output = report.ratio == 0 ? 0.0 : io::nearest(Rational(1 / report.ratio));
  const std::vector<std::int64_t>& counts = report.design.teeth;
  report.carrier_speed_per_input = carrier_speed_per_sun(teeth.sun, teeth.fixed_ring);
  if (design.cut) {
    report.gears = gearbox::describe_gears(*design.cut, {1.0, planet, planet, 0.0, output});
    return;
  }
  report.gears = {
      describe_gear("sun", counts[0], "layer_1", false, module, cutters, 1.0),
      describe_gear("planet_1", counts[1], "layer_1", false, module, cutters, planet),
      describe_gear("planet_2", counts[2], "layer_2", false, module, cutters, planet),
      describe_gear("fixed_ring", counts[3], "layer_1", true, module, cutters, 0.0),
      describe_gear("output_ring", counts[4], "layer_2", true, module, cutters, output)};
}

/// By mesh: sun, fixed ring, output ring.
std::vector<ContactPath<double>> paths_of(const ThreeKDesign& design) {
  if (design.cut) return contact_paths(*design.cut);
  const auto& counts = design.teeth;
  return {external_path_of(counts.sun, counts.planet_1),
          internal_path_of(counts.planet_1, counts.fixed_ring),
          internal_path_of(counts.planet_2, counts.output_ring)};
}

ThreeKRadii base_radii_mm(const ThreeKDesign& design) {
  if (!design.cut) {
    return radii_mm(design.real_teeth(), io::nearest(design.module_mm) / 2.0 * kReferenceCosine);
  }
  const std::vector<CutGear>& gears = design.cut->gears;
  return {base_radius_mm(gears[0]), base_radius_mm(gears[3]), base_radius_mm(gears[4])};
}

void describe_meshes(const ThreeKDesign& design, DesignReport& report) {
  const ThreeKTeeth<double> teeth = design.real_teeth();
  const std::vector<ContactPath<double>> paths = paths_of(design);
  const std::vector<double> losses{
      loss_per_friction(paths[0], 1.0 / teeth.sun + 1.0 / teeth.planet_1),
      loss_per_friction(paths[1], 1.0 / teeth.planet_1 - 1.0 / teeth.fixed_ring),
      loss_per_friction(paths[2], 1.0 / teeth.planet_2 - 1.0 / teeth.output_ring)};
  const auto& friction = design.problem.friction_coefficient;
  report.meshes = {describe_mesh("sun_planet_1", paths[0], losses[0], friction),
                   describe_mesh("planet_1_fixed_ring", paths[1], losses[1], friction),
                   describe_mesh("planet_2_output_ring", paths[2], losses[2], friction)};

  const double ratio_1 = basic_ratio_1(teeth);
  const double ratio_2 = basic_ratio_2(teeth);
  const LossWeights weights = three_k_loss_weights(ratio_1, ratio_2);
  share_losses({weights.sun_planet_1, weights.planet_1_fixed_ring, weights.planet_2_output_ring},
               losses, report.meshes);
  const ThreeKBacklash backlash = three_k_backlash(ratio_1, ratio_2, base_radii_mm(design));
  report.output_backlash_rad_per_mm = share_backlash(
      {backlash.sun_planet_1, backlash.planet_1_fixed_ring, backlash.planet_2_output_ring},
      report.meshes);
}

void describe_efficiency(const ThreeKDesign& design, DesignReport& report) {
  const ThreeKTeeth<double> teeth = design.real_teeth();
  // The exact test decides whether the output moves, not the rounded I2.
  const double ratio_2 = design.stands_still() ? 1.0 : basic_ratio_2(teeth);
  const ThreeKMeshEfficiencies<double> mesh{
      report.meshes[0].efficiency, report.meshes[1].efficiency, report.meshes[2].efficiency};
  const double ratio_1 = basic_ratio_1(teeth);
  const TrainEfficiency efficiency = three_k_efficiency(ratio_1, ratio_2, mesh);
  report.forward_efficiency = efficiency.forward;
  report.backward_efficiency = efficiency.backward;
  report.self_locking = efficiency.flow == PowerFlow::kSelfLocking;
  const auto listed = [](const ThreeKLosses& losses) -> std::vector<double> {
    return {losses.sun_planet_1, losses.planet_1_fixed_ring, losses.planet_2_output_ring};
  };
  state_losses(listed(three_k_forward_losses(ratio_1, ratio_2, mesh, efficiency)),
               listed(three_k_backward_losses(ratio_1, ratio_2, mesh, efficiency)), report.meshes);
}

ThreeKRadii working_radii_m(const ThreeKDesign& design) {
  if (design.cut) return working_radii(design.real_teeth(), design.cut->centre_mm * 1e-3);
  const ThreeKRadii pitch_mm = radii_mm(design.real_teeth(), io::nearest(design.module_mm) / 2.0);
  return {pitch_mm.sun_m * 1e-3, pitch_mm.fixed_ring_m * 1e-3, pitch_mm.output_ring_m * 1e-3};
}

void describe_loads(const ThreeKDesign& design, DesignReport& report) {
  if (!design.problem.load_output_torque_Nm || design.stands_still()) return;
  const ThreeKRadii pitch_m = working_radii_m(design);
  const ThreeKLoads loads = three_k_loads(io::nearest(*design.problem.load_output_torque_Nm),
                                          io::nearest(report.ratio), design.planet_count, pitch_m);
  report.input_torque_Nm = loads.sun_torque_Nm;
  report.fixed_ring_torque_Nm = loads.fixed_ring_torque_Nm;
  report.planet_tilting_force_N = loads.tilting_force_N();
  report.meshes[0].tangential_force_N = loads.sun_force_N;
  report.meshes[1].tangential_force_N = loads.fixed_ring_force_N;
  report.meshes[2].tangential_force_N = loads.output_ring_force_N;
}

void describe_bodies(const ThreeKDesign& design, DesignReport& report) {
  const Problem& problem = design.problem;
  if (design.cut) return describe_shifted_bodies(problem, *design.cut, report);
  const std::int64_t largest = std::max(design.teeth.fixed_ring, design.teeth.output_ring);
  report.hollow_shaft_diameter_mm = hollow_shaft_mm(problem, design.module_mm, design.teeth.sun);
  report.ring_blank_diameter_mm = io::nearest(ring_blank_mm(problem, design.module_mm, largest));
  const auto blank = blank_of(problem, design.module_mm, {"layer_1", "layer_2"});
  if (!blank) return;
  const ThreeKTeeth<double> teeth = design.real_teeth();
  report.mass_kg = three_k_mass_kg(*blank, design.planet_count, teeth);
  if (design.stands_still()) return;
  report.reflected_inertia_kg_m2 = reflected_inertia_kg_m2(
      three_k_reduction(teeth),
      three_k_inertia_at_sun_kg_m2(*blank, io::nearest(problem.rotor_inertia_kg_m2),
                                   design.planet_count, teeth));
}

/// Equation (1) of seed 001 with Z_P3 read as Z_P2, exact until the last rounding.
double paper_cost(const ThreeKDesign& design) {
  const auto square = [](const Rational& x) { return Rational(x * x); };
  const Rational bore = design.problem.rotor_inner_diameter_mm / design.module_mm;
  const Rational cost = 1 / square(design.teeth.sun) + square(design.teeth.fixed_ring - bore) +
                        square(design.teeth.planet_1) + square(design.teeth.planet_2) +
                        square(design.teeth.output_ring);
  return io::nearest(cost);
}

std::vector<ConstraintReport> constraints_of(const ThreeKDesign& design,
                                             const DesignReport& described, const Design& chosen) {
  std::vector<ConstraintReport> list = paper_constraints(design);
  if (design.problem.constraints == ConstraintSet::kBuildable) {
    for (ConstraintReport& report : further_constraints(design)) list.push_back(std::move(report));
  }
  for (ConstraintReport& report : floor_constraints(design.problem, described)) {
    list.push_back(std::move(report));
  }
  for (ConstraintReport& report : coaxiality_constraints(design)) list.push_back(std::move(report));
  for (ConstraintReport& report : choices(design.problem, chosen))
    list.push_back(std::move(report));
  return list;
}

ThreeKTeeth<double> named(Numbers teeth) {
  return {teeth[0], teeth[1], teeth[2], teeth[3], teeth[4]};
}

double reduction(Numbers teeth) { return three_k_reduction(named(teeth)); }

std::vector<double> forces_N(Numbers teeth, std::int64_t planet_count, double centre_m) {
  const double ratio = reduction(teeth);
  const ThreeKLoads loads =
      three_k_loads(ratio, ratio, planet_count, working_radii(named(teeth), centre_m));
  return {std::abs(loads.sun_force_N), std::abs(loads.fixed_ring_force_N),
          std::abs(loads.output_ring_force_N)};
}

TrainEfficiency efficiency(Numbers teeth, Numbers mesh) {
  return three_k_efficiency(basic_ratio_1(named(teeth)), basic_ratio_2(named(teeth)),
                            {mesh[0], mesh[1], mesh[2]});
}

AssemblyPhase assemble(ToothCounts teeth, std::int64_t planet_count) {
  return assemble_3k({teeth[0], teeth[1], teeth[2], teeth[3], teeth[4]}, planet_count);
}

}  // namespace

ThreeKTeeth<double> ThreeKDesign::real_teeth() const {
  return {static_cast<double>(teeth.sun), static_cast<double>(teeth.planet_1),
          static_cast<double>(teeth.planet_2), static_cast<double>(teeth.fixed_ring),
          static_cast<double>(teeth.output_ring)};
}

bool ThreeKDesign::stands_still() const {
  return Rational(teeth.output_ring) * teeth.planet_1 ==
         Rational(teeth.fixed_ring) * teeth.planet_2;
}

std::vector<std::int64_t> complete(std::span<const std::int64_t> free_teeth) {
  const std::int64_t sun = free_teeth[0];
  const std::int64_t planet_1 = free_teeth[1];
  const std::int64_t planet_2 = free_teeth[2];
  return {sun, planet_1, planet_2, sun + 2 * planet_1, sun + planet_1 + planet_2};
}

DesignReport evaluate(const Problem& problem, const Design& design) {
  DesignReport report;
  report.design = design;
  if (report.design.teeth.size() == 3) report.design.teeth = complete(design.teeth);
  const std::vector<std::int64_t>& z = report.design.teeth;
  const ThreeKDesign train{problem,
                           {z[0], z[1], z[2], z[3], z[4]},
                           design.planet_count,
                           design.module_mm,
                           cut_of(problem, report.design)};
  report.planet_types = planet_type_count(train.teeth, design.planet_count);
  if (!train.stands_still()) {
    report.ratio = three_k_reduction<Rational>({z[0], z[1], z[2], z[3], z[4]});
  }
  describe_gears(train, report);
  describe_meshes(train, report);
  if (train.cut) state_working_angles(*train.cut, report);
  describe_efficiency(train, report);
  describe_loads(train, report);
  state_input_torques(problem, report);
  state_rotor(problem, report);
  describe_bodies(train, report);
  state_objective(problem, paper_cost(train), report);
  report.constraints = constraints_of(train, report, design);
  report.remarks = remarks(train, report);
  return report;
}

Topology topology() {
  Topology record{train_parts("3k")};
  record.complete = complete;
  record.model = model;
  record.free_teeth = free_teeth;
  record.point_of = point_of;
  record.evaluate = evaluate;
  record.reduction = reduction;
  record.forces_N = forces_N;
  record.efficiency = efficiency;
  record.assemble = assemble;
  record.drawn = {{"sun", "S", "sun"},
                  {"planet_1", "P1", "planet 1"},
                  {"planet_2", "P2", "planet 2"},
                  {"fixed_ring", "F", "fixed ring"},
                  {"output_ring", "O", "output ring"}};
  record.views = {"Layer 1: sun, planets 1, fixed ring",
                  "Layer 2: planets 2, output ring (sun dashed)"};
  return record;
}

}  // namespace torquewright::gearbox::three_k
