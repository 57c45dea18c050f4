// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/stepped_train.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "gearbox/constraints/floors.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/topologies/report_parts.hpp"
#include "gearbox/topologies/shifted_train.hpp"
#include "gearbox/train/assembly.hpp"
#include "gearbox/train/central_gears.hpp"

namespace torquewright::gearbox {
namespace {

/// One design as its evaluation sees it: as it is cut, with profile shift or without.
struct SteppedDesign {
  const Problem& problem;
  const TrainParts& parts;
  CutTrain cut;
  std::vector<double> teeth;
  bool stands_still = false;

  std::int64_t count(std::size_t gear) const { return cut.train.teeth[gear]; }
};

/// The teeth as assembly knows them. A sun outside the planets is a ring of as many teeth below
/// zero: it takes the place of the ring that planet 1 lacks. kinematics.md eq. (20).
ThreeKTeeth<std::int64_t> assembled_teeth(const TrainParts& parts, ToothCounts teeth) {
  const auto ring_1 = parts.ring_of_layer(0);
  return {teeth[0], teeth[1], teeth[2], ring_1 ? teeth[*ring_1] : -teeth[0],
          teeth[parts.ring_of_layer(1).value()]};
}

std::vector<Rational> exact_teeth(ToothCounts teeth) {
  std::vector<Rational> list;
  for (const std::int64_t count : teeth) list.emplace_back(static_cast<long>(count));
  return list;
}

std::vector<std::int64_t> complete(const TrainParts& parts, ToothCounts free_teeth) {
  std::vector<std::int64_t> teeth(free_teeth.begin(), free_teeth.end());
  for (std::size_t gear = parts.free_gears; gear < parts.gears.size(); ++gear) {
    teeth.push_back(teeth[0] + teeth[1] + teeth[parts.planet_beside(gear)]);
  }
  return teeth;
}

void describe_meshes(const SteppedDesign& design, DesignReport& report) {
  const std::vector<ContactPath<double>> paths = contact_paths(design.cut);
  std::vector<double> losses;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const MeshedGears& mesh = design.parts.meshes[i];
    const double sign = design.parts.is_ring(mesh.gear_2) ? -1.0 : 1.0;
    losses.push_back(loss_per_friction(
        paths[i], 1.0 / design.teeth[mesh.gear_1] + sign / design.teeth[mesh.gear_2]));
    report.meshes.push_back(describe_mesh(std::string(mesh.name), paths[i], losses.back(),
                                          design.problem.friction_coefficient));
  }
  const auto [first, second] = basic_ratios<double>(design.parts, design.teeth);
  const LossWeights weights = three_k_loss_weights(first, design.stands_still ? 1.0 : second);
  share_losses(by_mesh(design.parts, weights.sun_planet_1, weights.planet_1_fixed_ring,
                       weights.planet_2_output_ring),
               losses, report.meshes);
  if (design.stands_still) return;
  std::vector<double> base_mm;
  for (const CutGear& gear : design.cut.gears) base_mm.push_back(base_radius_mm(gear));
  report.output_backlash_rad_per_mm =
      share_backlash(mesh_backlash_rad_per_m(design.parts, design.teeth, base_mm), report.meshes);
}

void describe_efficiency(const SteppedDesign& design, DesignReport& report) {
  auto [first, second] = basic_ratios<double>(design.parts, design.teeth);
  if (design.stands_still) second = 1.0;  // The exact test decides, not the rounded I2.
  std::vector<double> efficiencies;
  for (const MeshReport& mesh : report.meshes) efficiencies.push_back(mesh.efficiency);
  const ThreeKMeshEfficiencies<double> mesh = by_role(design.parts, efficiencies);
  const TrainEfficiency efficiency = three_k_efficiency(first, second, mesh);
  report.forward_efficiency = efficiency.forward;
  report.backward_efficiency = efficiency.backward;
  report.self_locking = efficiency.flow == PowerFlow::kSelfLocking;
  const auto listed = [&](const ThreeKLosses& losses) {
    return by_mesh(design.parts, losses.sun_planet_1, losses.planet_1_fixed_ring,
                   losses.planet_2_output_ring);
  };
  state_losses(listed(three_k_forward_losses(first, second, mesh, efficiency)),
               listed(three_k_backward_losses(first, second, mesh, efficiency)), report.meshes);
}

void describe_loads(const SteppedDesign& design, DesignReport& report) {
  const auto& load = design.problem.load_output_torque_Nm;
  if (!load || design.stands_still) return;
  const double output_Nm = io::nearest(*load);
  report.input_torque_Nm = output_Nm / io::nearest(report.ratio);
  report.fixed_ring_torque_Nm = output_Nm - *report.input_torque_Nm;
  const std::vector<double> forces_N = mesh_forces_N(
      design.parts, design.teeth, design.cut.train.planet_count, design.cut.centre_mm * 1e-3);
  for (std::size_t i = 0; i < forces_N.size(); ++i) {
    report.meshes[i].tangential_force_N = forces_N[i] * std::abs(*report.input_torque_Nm);
  }
  // The second layer has one mesh, and the first pulls against it.
  report.planet_tilting_force_N = report.meshes.back().tangential_force_N;
}

/// The circle that the largest ring's pitch circle is, or that of all planets 1 without a ring.
ConstraintReport rotor_bore_of(const SteppedDesign& design) {
  const TrainParts& parts = design.parts;
  Rational module_mm = io::exact(design.cut.gears[0].module_mm);
  std::int64_t largest = parts.ring_of_layer(0) ? 0 : design.count(0) + 2 * design.count(1);
  for (std::size_t gear = parts.free_gears; gear < parts.gears.size(); ++gear) {
    const Rational own_mm = io::exact(design.cut.gears[gear].module_mm);
    if (own_mm * design.count(gear) < module_mm * largest) continue;
    module_mm = own_mm;
    largest = design.count(gear);
  }
  return rotor_bore(design.problem, module_mm, largest);
}

std::vector<ConstraintReport> constraints_of(const SteppedDesign& design,
                                             const DesignReport& described, const Design& chosen) {
  const Problem& problem = design.problem;
  const std::int64_t planets = design.cut.train.planet_count;
  std::vector<ConstraintReport> list{ratio_window(problem, described.ratio, !design.stands_still)};
  for (std::size_t gear = 0; gear < design.parts.free_gears; ++gear) {
    list.push_back(
        minimum_teeth(problem, std::string(design.parts.gears[gear]), design.count(gear)));
  }
  const PlanetCircle circle{design.count(0), design.count(1), planets,
                            io::exact(design.cut.gears[0].module_mm)};
  list.push_back(carrier_clearance(circle, problem.min_carrier_clearance_rad));
  list.push_back(rotor_bore_of(design));
  if (const auto ring = design.parts.ring_of_layer(0)) {
    list.push_back(equal_spacing(design.count(0), design.count(*ring), planets));
  }
  list.push_back(identical_planets(assembled_teeth(design.parts, design.cut.train.teeth), planets));
  const auto add = [&](std::vector<ConstraintReport> more) {
    std::move(more.begin(), more.end(), std::back_inserter(list));
  };
  add(shifted_conditions(problem, design.cut));
  add(floor_constraints(problem, described));
  add(shifted_coaxiality(design.cut));
  add(choices(problem, chosen));
  return list;
}

void append_efficiency_remark(const SteppedDesign& design, const DesignReport& report,
                              std::vector<Remark>& list) {
  if (design.stands_still) {
    list.push_back({"efficiency", "efficiency: does not exist, the output stands still."});
  } else if (report.forward_efficiency == 0.0) {
    list.push_back({"efficiency", "efficiency: does not exist, a mesh passes no power."});
  } else if (!design.problem.friction_coefficient) {
    list.push_back(
        {"efficiency", "efficiency: no friction coefficient is given, so losses are left out."});
  } else if (report.self_locking) {
    list.push_back(
        {"self_locking", "self_locking: the output cannot drive the sun, whatever the load."});
  }
}

/// Sun and ring of a single stage whose planets can stand where these can: kinematics.md eq. (20).
std::pair<std::int64_t, std::int64_t> spacing_teeth(const SteppedDesign& design) {
  if (const auto ring = design.parts.ring_of_layer(0)) {
    return {design.count(0), design.count(*ring)};
  }
  const std::int64_t common = std::gcd(design.count(1), design.count(2));
  const std::int64_t ring = design.count(design.parts.held_ring);
  return {design.count(0) * (design.count(2) / common), ring * (design.count(1) / common)};
}

std::vector<Remark> remarks_of(const SteppedDesign& design, const DesignReport& report) {
  const auto [sun, ring] = spacing_teeth(design);
  std::vector<Remark> list = common_remarks(design.problem, report, sun, ring);
  append_efficiency_remark(design, report, list);
  for (std::size_t i = 0; i < design.cut.meshes.size(); ++i) {
    const CutMesh& mesh = design.cut.meshes[i];
    if (design.parts.is_ring(mesh.gear_2)) {
      list.push_back(trimming_remark(std::string(mesh.name), mesh.cut));
    }
    if (auto remark = hunting_remark(std::string(mesh.name), design.count(mesh.gear_1),
                                     design.count(mesh.gear_2))) {
      list.push_back(*std::move(remark));
    }
  }
  return list;
}

CutTrain cut_or_throw(const Problem& problem, const Design& design) {
  auto cut = cut_train(gear_train(problem, design));
  if (!cut) throw std::invalid_argument(shift_objection(problem, design));
  return *std::move(cut);
}

DesignReport evaluate(const TrainParts& parts, const Problem& problem, const Design& design) {
  DesignReport report;
  report.design = design;
  if (design.teeth.size() == parts.free_gears) report.design.teeth = complete(parts, design.teeth);
  const std::vector<std::int64_t>& z = report.design.teeth;
  SteppedDesign train{problem, parts, cut_or_throw(problem, report.design), {z.begin(), z.end()}};
  const auto ratios = basic_ratios<Rational>(parts, exact_teeth(z));
  train.stands_still = ratios.second == 1;
  if (!train.stands_still) report.ratio = ratios.reduction();
  report.planet_types = planet_type_count(assembled_teeth(parts, z), design.planet_count);
  const TrainSpeeds speeds = train_speeds(parts, train.teeth);
  report.carrier_speed_per_input = speeds.carrier;
  report.gears = describe_gears(train.cut, speeds.gears);
  describe_meshes(train, report);
  state_working_angles(train.cut, report);
  describe_efficiency(train, report);
  describe_loads(train, report);
  state_input_torques(problem, report);
  state_rotor(problem, report);
  describe_shifted_bodies(problem, train.cut, report);
  state_objective(problem, 0.0, report);
  report.constraints = constraints_of(train, report, design);
  report.remarks = remarks_of(train, report);
  return report;
}

AssemblyPhase assemble(const TrainParts& parts, ToothCounts teeth, std::int64_t planet_count) {
  const ThreeKTeeth<std::int64_t> z = assembled_teeth(parts, teeth);
  if (parts.ring_of_layer(0)) {
    return assemble_3k({z.sun, z.planet_1, z.planet_2, z.fixed_ring, z.output_ring}, planet_count);
  }
  return assemble_compound(z.sun, z.planet_1, z.planet_2, z.output_ring, planet_count);
}

}  // namespace

Topology stepped_train(std::string_view name) {
  const TrainParts* parts = &train_parts(name);
  Topology record{*parts};
  record.complete = [parts](ToothCounts free_teeth) { return complete(*parts, free_teeth); };
  record.evaluate = [parts](const Problem& problem, const Design& design) {
    return evaluate(*parts, problem, design);
  };
  record.reduction = [parts](Numbers teeth) {
    return basic_ratios<double>(*parts, teeth).reduction();
  };
  record.forces_N = [parts](Numbers teeth, std::int64_t planet_count, double centre_m) {
    return mesh_forces_N(*parts, teeth, planet_count, centre_m);
  };
  record.efficiency = [parts](Numbers teeth, Numbers meshes) {
    return train_efficiency(*parts, teeth, meshes);
  };
  record.assemble = [parts](ToothCounts teeth, std::int64_t planet_count) {
    return assemble(*parts, teeth, planet_count);
  };
  return record;
}

}  // namespace torquewright::gearbox
