// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/planetary.hpp"

#include "gearbox/constraints/buildable.hpp"
#include "gearbox/constraints/floors.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/topologies/planetary_model.hpp"
#include "gearbox/topologies/report_parts.hpp"
#include "gearbox/topologies/shifted_train.hpp"
#include "gearbox/train/backlash.hpp"
#include "gearbox/train/inertia.hpp"
#include "gearbox/train/loads.hpp"
#include "gearbox/train/power_flow.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox::planetary {

namespace {

struct Stage {
  const Problem& problem;
  PlanetaryTeeth<std::int64_t> teeth;
  std::int64_t planet_count;
  Rational module_mm;
  std::optional<CutTrain> cut = {};  ///< Of gears with profile shift only.

  PlanetaryTeeth<double> real_teeth() const {
    return {static_cast<double>(teeth.sun), static_cast<double>(teeth.planet),
            static_cast<double>(teeth.ring)};
  }
};

void describe_gears(const Stage& stage, DesignReport& report) {
  const PlanetaryTeeth<double> teeth = stage.real_teeth();
  const Rational& module = stage.module_mm;
  const StatedCutters& cutters = stage.problem.cutters;
  const double planet = planet_speed_per_sun(teeth.sun, teeth.planet, teeth.ring);
  report.carrier_speed_per_input = carrier_speed_per_sun(teeth.sun, teeth.ring);
  if (stage.cut) {
    report.gears = gearbox::describe_gears(*stage.cut, {1.0, planet, 0.0});
    return;
  }
  report.gears = {
      describe_gear("sun", stage.teeth.sun, "layer_1", false, module, cutters, 1.0),
      describe_gear("planet", stage.teeth.planet, "layer_1", false, module, cutters, planet),
      describe_gear("ring", stage.teeth.ring, "layer_1", true, module, cutters, 0.0)};
}

/// By mesh: sun, ring.
std::vector<ContactPath<double>> paths_of(const Stage& stage) {
  if (stage.cut) return contact_paths(*stage.cut);
  return {external_path_of(stage.teeth.sun, stage.teeth.planet),
          internal_path_of(stage.teeth.planet, stage.teeth.ring)};
}

void describe_meshes(const Stage& stage, DesignReport& report) {
  const PlanetaryTeeth<double> teeth = stage.real_teeth();
  const std::vector<ContactPath<double>> paths = paths_of(stage);
  const std::vector<double> losses{
      loss_per_friction(paths[0], 1.0 / teeth.sun + 1.0 / teeth.planet),
      loss_per_friction(paths[1], 1.0 / teeth.planet - 1.0 / teeth.ring)};
  const auto& friction = stage.problem.friction_coefficient;
  report.meshes = {describe_mesh("sun_planet", paths[0], losses[0], friction),
                   describe_mesh("planet_ring", paths[1], losses[1], friction)};
  share_losses({1.0, 1.0}, losses, report.meshes);
  const double base_mm = io::nearest(stage.module_mm) / 2.0 * kReferenceCosine;
  const double backlash = planetary_backlash(base_mm * teeth.sun, base_mm * teeth.ring);
  report.output_backlash_rad_per_mm = share_backlash({backlash, backlash}, report.meshes);
}

void describe_efficiency(const Stage& stage, DesignReport& report) {
  const double ratio = static_cast<double>(stage.teeth.ring) / static_cast<double>(stage.teeth.sun);
  const PlanetaryMeshEfficiencies<double> mesh{report.meshes[0].efficiency,
                                               report.meshes[1].efficiency};
  const TrainEfficiency efficiency = planetary_efficiency(ratio, mesh);
  report.forward_efficiency = efficiency.forward;
  report.backward_efficiency = efficiency.backward;
  report.self_locking = false;
  const PlanetaryLosses forward = planetary_forward_losses(ratio, mesh, efficiency);
  const PlanetaryLosses backward = planetary_backward_losses(ratio, mesh, efficiency);
  state_losses({forward.sun_planet, forward.planet_ring},
               {backward.sun_planet, backward.planet_ring}, report.meshes);
}

void describe_loads(const Stage& stage, DesignReport& report) {
  if (!stage.problem.load_output_torque_Nm) return;
  const PlanetaryTeeth<double> teeth = stage.real_teeth();
  const double centre_mm = stage.cut
                               ? stage.cut->centre_mm
                               : io::nearest(stage.module_mm) * (teeth.sun + teeth.planet) / 2.0;
  const PlanetaryLoads loads =
      planetary_loads(io::nearest(*stage.problem.load_output_torque_Nm), io::nearest(report.ratio),
                      stage.planet_count, working_radii(teeth, centre_mm * 1e-3));
  report.input_torque_Nm = loads.sun_torque_Nm;
  report.fixed_ring_torque_Nm = loads.ring_torque_Nm;
  report.meshes[0].tangential_force_N = loads.sun_force_N;
  report.meshes[1].tangential_force_N = loads.ring_force_N;
}

void describe_bodies(const Stage& stage, DesignReport& report) {
  const Problem& problem = stage.problem;
  if (stage.cut) return describe_shifted_bodies(problem, *stage.cut, report);
  report.hollow_shaft_diameter_mm = hollow_shaft_mm(problem, stage.module_mm, stage.teeth.sun);
  report.ring_blank_diameter_mm =
      io::nearest(ring_blank_mm(problem, stage.module_mm, stage.teeth.ring));
  const auto blank = blank_of(problem, stage.module_mm, {"layer_1"});
  if (!blank) return;
  const PlanetaryTeeth<double> teeth = stage.real_teeth();
  report.mass_kg = planetary_mass_kg(*blank, stage.planet_count, teeth);
  report.reflected_inertia_kg_m2 = reflected_inertia_kg_m2(
      planetary_reduction(teeth),
      planetary_inertia_at_sun_kg_m2(*blank, io::nearest(problem.rotor_inertia_kg_m2),
                                     stage.planet_count, teeth));
}

std::vector<ConstraintReport> plain_constraints(const Stage& stage, const Design& completed) {
  const PlanetaryTeeth<std::int64_t>& teeth = stage.teeth;
  std::vector<ConstraintReport> list =
      buildable_constraints(stage.problem, train_parts(stage.problem.topology), completed, {});
  if (teeth.ring != teeth.sun + 2 * teeth.planet) {
    list.push_back(coaxiality("ring", teeth.planet, teeth.ring, teeth.sun + teeth.planet));
  }
  return list;
}

std::vector<ConstraintReport> shifted_constraints(const Problem& problem, const CutTrain& cut) {
  std::vector<ConstraintReport> list = shifted_conditions(problem, cut);
  for (ConstraintReport& report : shifted_coaxiality(cut)) list.push_back(std::move(report));
  return list;
}

std::vector<ConstraintReport> constraints_of(const Stage& stage, const DesignReport& described,
                                             const Design& chosen) {
  const Problem& problem = stage.problem;
  const PlanetaryTeeth<std::int64_t>& teeth = stage.teeth;
  const PlanetCircle circle{teeth.sun, teeth.planet, stage.planet_count, stage.module_mm};
  std::vector<ConstraintReport> list{ratio_window(problem, described.ratio, true),
                                     minimum_teeth(problem, "sun", teeth.sun),
                                     minimum_teeth(problem, "planet", teeth.planet),
                                     carrier_clearance(circle, problem.min_carrier_clearance_rad),
                                     rotor_bore(problem, stage.module_mm, teeth.ring),
                                     equal_spacing(teeth.sun, teeth.ring, stage.planet_count)};
  for (ConstraintReport& report : stage.cut ? shifted_constraints(problem, *stage.cut)
                                            : plain_constraints(stage, described.design)) {
    list.push_back(std::move(report));
  }
  for (ConstraintReport& report : floor_constraints(problem, described)) {
    list.push_back(std::move(report));
  }
  for (ConstraintReport& report : choices(problem, chosen)) list.push_back(std::move(report));
  return list;
}

std::vector<Remark> remarks(const Stage& stage, const DesignReport& report) {
  const PlanetaryTeeth<std::int64_t>& teeth = stage.teeth;
  std::vector<Remark> list = common_remarks(stage.problem, report, teeth.sun, teeth.ring);
  if (report.forward_efficiency == 0.0) {
    list.push_back({"efficiency", "efficiency: does not exist, a mesh passes no power."});
  } else if (!stage.problem.friction_coefficient) {
    list.push_back(
        {"efficiency", "efficiency: no friction coefficient is given, so losses are left out."});
  }
  list.push_back(stage.cut ? trimming_remark("planet_ring", stage.cut->meshes[1].cut)
                           : trimming_remark("planet_ring", teeth.planet, teeth.ring));
  if (auto remark = hunting_remark("sun_planet", teeth.sun, teeth.planet)) list.push_back(*remark);
  if (auto remark = hunting_remark("planet_ring", teeth.planet, teeth.ring))
    list.push_back(*remark);
  return list;
}

double reduction(Numbers teeth) {
  return planetary_reduction(PlanetaryTeeth<double>{teeth[0], teeth[1], teeth[2]});
}

std::vector<double> forces_N(Numbers teeth, std::int64_t planet_count, double centre_m) {
  const double ratio = reduction(teeth);
  const PlanetaryTeeth<double> all{teeth[0], teeth[1], teeth[2]};
  const PlanetaryLoads loads =
      planetary_loads(ratio, ratio, planet_count, working_radii(all, centre_m));
  return {loads.sun_force_N, loads.ring_force_N};
}

TrainEfficiency efficiency(Numbers teeth, Numbers mesh) {
  return planetary_efficiency(teeth[2] / teeth[0], {mesh[0], mesh[1]});
}

AssemblyPhase assemble(ToothCounts teeth, std::int64_t planet_count) {
  return assemble_planetary(teeth[0], teeth[1], teeth[2], planet_count);
}

std::vector<std::int64_t> largest_of_same_ratio(ToothCounts teeth, std::int64_t most) {
  const std::int64_t own_sun = teeth[0], own_ring = teeth[2];
  for (std::int64_t sun = most * own_sun / own_ring; sun > 0; --sun) {
    if (sun * own_ring % own_sun != 0) continue;
    const std::int64_t ring = sun * own_ring / own_sun;
    if ((ring - sun) % 2 == 0) return {sun, (ring - sun) / 2, ring};
  }
  return {};
}

}  // namespace

std::vector<std::int64_t> complete(std::span<const std::int64_t> free_teeth) {
  return {free_teeth[0], free_teeth[1], free_teeth[0] + 2 * free_teeth[1]};
}

DesignReport evaluate(const Problem& problem, const Design& design) {
  DesignReport report;
  report.design = design;
  if (report.design.teeth.size() == 2) report.design.teeth = complete(design.teeth);
  const std::vector<std::int64_t>& z = report.design.teeth;
  const Stage stage{problem,
                    {z[0], z[1], z[2]},
                    design.planet_count,
                    design.module_mm,
                    cut_of(problem, report.design)};
  report.ratio = planetary_reduction<Rational>({z[0], z[1], z[2]});
  describe_gears(stage, report);
  describe_meshes(stage, report);
  if (stage.cut) state_working_angles(*stage.cut, report);
  describe_efficiency(stage, report);
  describe_loads(stage, report);
  state_input_torques(problem, report);
  state_rotor(problem, report);
  describe_bodies(stage, report);
  state_objective(problem, 0.0, report);
  report.constraints = constraints_of(stage, report, design);
  report.remarks = remarks(stage, report);
  return report;
}

Topology topology() {
  Topology record{train_parts("planetary")};
  record.complete = complete;
  record.model = model;
  record.free_teeth = free_teeth;
  record.point_of = point_of;
  record.evaluate = evaluate;
  record.reduction = reduction;
  record.forces_N = forces_N;
  record.efficiency = efficiency;
  record.assemble = assemble;
  record.largest_of_same_ratio = largest_of_same_ratio;
  // Drawn as the first layer of a 3K train.
  record.drawn = {{"sun", "S", "sun"}, {"planet_1", "P", "planet"}, {"fixed_ring", "R", "ring"}};
  record.views = {"Sun, planets, ring"};
  return record;
}

}  // namespace torquewright::gearbox::planetary
