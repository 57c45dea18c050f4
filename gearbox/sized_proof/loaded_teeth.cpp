// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/loaded_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/constraints/gear_cutters.hpp"
#include "gearbox/constraints/hob_reach.hpp"
#include "gearbox/sized_proof/enclosures/affine.hpp"
#include "gearbox/strength/mesh_stiffness.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/strength/steels.hpp"
#include "gearbox/strength/strength.hpp"
#include "gearbox/train/gear_train.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox::sized {
namespace {

double widest_mm(const SynthesisRequest& request, double module_mm, double fewest_teeth) {
  const auto limit = [](const std::optional<Rational>& most, double size_mm) {
    return most ? io::nearest(*most) * size_mm : kInfinity;
  };
  return std::min({limit(request.greatest_face_width_mm, 1.0),
                   limit(request.greatest_face_width_over_module, module_mm),
                   limit(request.greatest_face_width_over_diameter, module_mm * fewest_teeth)});
}

/// Rolling without slip, the carrier at 1: z (w - 1) = -+ p (w_P - 1) of a sun, a ring; the held
/// ring stands. Then over the sun's speed.
void set_speeds(const TrainParts& parts, LoadedTeeth& teeth) {
  teeth.held_layer = parts.gear_layers[parts.held_ring];
  if (parts.output_ring) teeth.output_layer = parts.gear_layers[*parts.output_ring];
  const double spin = -teeth.ring[teeth.held_layer] / teeth.planet[teeth.held_layer];
  const double sun_speed = 1.0 - spin * teeth.planet[0] / teeth.sun;
  for (const std::size_t layer : {0U, 1U}) {
    if (teeth.ring[layer] == 0.0 || layer == teeth.held_layer) continue;
    teeth.ring_speed[layer] = (1.0 + spin * teeth.planet[layer] / teeth.ring[layer]) / sun_speed;
  }
  teeth.carrier_speed = 1.0 / sun_speed;
  teeth.planet_speed = (1.0 + spin) / sun_speed;
  teeth.ratio =
      1.0 / (teeth.output_layer ? teeth.ring_speed[*teeth.output_layer] : teeth.carrier_speed);
}

/// The torques on sun, output and held ring add up to nothing.
void set_forces(double load_Nm, LoadedTeeth& teeth) {
  const double sun_Nm = load_Nm / teeth.ratio;
  const auto force_N = [&](double torque_Nm, double module_mm, double count) {
    return std::abs(2e3 * torque_Nm / (teeth.planets * module_mm * count));
  };
  teeth.sun_force_N = force_N(sun_Nm, teeth.module_mm[0], teeth.sun);
  for (const std::size_t layer : {0U, 1U}) {
    if (teeth.ring[layer] == 0.0) continue;
    const double torque_Nm = layer == teeth.held_layer ? load_Nm - sun_Nm : load_Nm;
    teeth.ring_force_N[layer] = force_N(torque_Nm, teeth.module_mm[layer], teeth.ring[layer]);
  }
}

/// By energy: the load's work at the output, T^2/(2 k), is that of the normal forces of all planets
/// along the line of action, n F^2/(2 c b) each.
void set_softness(const Problem& problem, LoadedTeeth& teeth) {
  teeth.least_Nm_rad = as_number(problem.floors.stiffness_Nm_rad);
  if (!teeth.least_Nm_rad) return;
  constexpr double kMetresPerMicrometre = 1e-6;
  const double load_Nm = io::nearest(torque_to_bear_Nm(problem));
  const double pair = kSingleStiffness_N_mm_um * find_steel(*problem.steel)->material.young_MPa /
                      kStiffnessYoung_MPa;
  const auto softness = [&](double force_N) {
    const double normal = force_N / kReferenceCosine / load_Nm;
    return kMetresPerMicrometre * teeth.planets * normal * normal / pair;
  };
  teeth.sun_softness = softness(teeth.sun_force_N);
  for (const std::size_t layer : {0U, 1U}) {
    teeth.ring_softness[layer] = softness(teeth.ring_force_N[layer]);
  }
}

/// The static limit is linear in the notch: two notches give the line.
RootStrength root_strength(const GearMaterial& steel, double cycles) {
  const LifeCurve blunt = root_life(steel, 1.0, 1.0), sharp = root_life(steel, 3.0, 1.0);
  RootStrength root;
  root.static_slope_MPa = 0.5 * (sharp.static_MPa - blunt.static_MPa);
  root.static_constant_MPa = blunt.static_MPa - root.static_slope_MPa;
  root.endurance_MPa = blunt.endurance_MPa;
  const double decades = std::log(blunt.endurance_cycles / blunt.static_cycles);
  root.static_share = std::clamp(std::log(blunt.endurance_cycles / cycles) / decades, 0.0, 1.0);
  return root;
}

void set_strength(const Problem& problem, std::int64_t planets, LoadedTeeth& teeth) {
  const GearMaterial& steel = find_steel(*problem.steel)->material;
  const LoadFactors factors = assumed_factors(planets);
  const double cycles = problem.load_cycles ? io::nearest(*problem.load_cycles) : kAssumedCycles;
  const double common = factors.application * factors.dynamic * factors.load_sharing;
  teeth.root = root_strength(steel, cycles);
  if (teeth.held_layer == 0) teeth.alternating = factors.alternating_bending;
  teeth.root_factors = common * factors.face_load_root * kAssumedRootSafety;
  teeth.flank_factors =
      common * factors.face_load_flank * kAssumedFlankSafety * kAssumedFlankSafety;
  const LifeCurve flank = flank_life(steel);
  teeth.flank_MPa = std::min(flank.static_MPa, flank.at_MPa(cycles));
  teeth.elasticity =
      elasticity_factor(steel.young_MPa, steel.poisson, steel.young_MPa, steel.poisson);
}

void set_limits(const Problem& problem, LoadedTeeth& teeth) {
  const Cutters cutters = stated_cutters(problem);
  teeth.hob_depth = cutters.hob_depth();
  teeth.shaper_depth = cutters.shaper_depth();
  teeth.undercut_depth = undercut_depth(cutters);
  teeth.hob_radius = cutters.hob_tip_radius;
  teeth.shaper_radius = cutters.shaper_tip_radius;
  if (cutters.shaper_teeth) teeth.shaper_teeth = real(*cutters.shaper_teeth);
  teeth.space_mm = io::nearest(ring_space_mm(problem));
  teeth.min_contact_ratio = std::max(1.0, io::nearest(problem.min_contact_ratio));
  teeth.min_neighbour_mm = io::nearest(problem.min_neighbour_clearance_mm);
  teeth.min_tip_thickness = io::nearest(problem.synthesis->least_tip_thickness);
  teeth.least_shift = io::nearest(problem.synthesis->least_shift);
  teeth.greatest_shift = io::nearest(problem.synthesis->greatest_shift);
  teeth.least_width_mm = io::nearest(problem.synthesis->least_face_width_mm);
  teeth.density_kg_m3 = io::nearest(*problem.density_kg_m3);
  teeth.friction = as_number(problem.friction_coefficient).value_or(0.0);
  teeth.rotor_kg_m2 = io::nearest(problem.rotor_inertia_kg_m2);
}

}  // namespace

double real(std::int64_t number) { return static_cast<double>(number); }

std::optional<double> as_number(const std::optional<Rational>& value) {
  if (!value) return std::nullopt;
  return io::nearest(*value);
}

std::vector<std::int64_t> teeth_in_order(const TrainParts& parts, const WholeNumbers& whole) {
  std::vector<std::int64_t> teeth{whole.sun};
  for (std::size_t gear = 1; gear < parts.gears.size(); ++gear) {
    const std::size_t layer = parts.gear_layers[gear];
    teeth.push_back(parts.is_ring(gear) ? whole.ring[layer] : whole.planet[layer]);
  }
  return teeth;
}

LoadedTeeth loaded_teeth(const Problem& problem, const WholeNumbers& whole) {
  const TrainParts& parts = train_parts(problem.topology);
  LoadedTeeth teeth;
  teeth.sun = real(whole.sun);
  teeth.planets = real(whole.planets);
  teeth.half_chord = std::sin(std::numbers::pi / teeth.planets);
  for (const std::size_t layer : {0U, 1U}) {
    teeth.planet[layer] = real(whole.planet[layer]);
    teeth.ring[layer] = real(whole.ring[layer]);
    teeth.module_mm[layer] = io::nearest(whole.module_mm[layer]);
    teeth.wall_mm[layer] = io::nearest(ring_wall_mm(problem, whole.module_mm[layer]));
    const double fewest = layer == 0 ? std::min(teeth.sun, teeth.planet[0]) : teeth.planet[layer];
    teeth.widest_mm[layer] = widest_mm(*problem.synthesis, teeth.module_mm[layer], fewest);
  }
  teeth.hollow_wall_mm = io::nearest(hollow_shaft_wall_mm(problem, whole.module_mm[0]));
  // Where the second layer holds its ring beside an output ring, planet 2 is the larger one.
  const bool may_pass =
      parts.layer_count() > 1 && (!parts.output_ring || parts.gear_layers[parts.held_ring] == 0);
  teeth.is_sun_below = may_pass && problem.sun_under_second_layer;
  set_limits(problem, teeth);
  set_speeds(parts, teeth);
  set_strength(problem, whole.planets, teeth);
  set_forces(io::nearest(torque_to_bear_Nm(problem)), teeth);
  set_softness(problem, teeth);
  return teeth;
}

}  // namespace torquewright::gearbox::sized
