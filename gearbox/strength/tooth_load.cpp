// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/tooth_load.hpp"

#include <algorithm>
#include <cmath>

#include "gearbox/strength/rim_factor.hpp"
#include "gearbox/strength/ring_section.hpp"
#include "gearbox/strength/strength.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

/// Root factors with the load at the tip, and Y_S with it at the outer point of single contact,
/// which the static notch factor asks for. A ring has factors for the tip only.
struct RootShape {
  RootFactors tip;
  double working_concentration = 0.0;
};

/// Of the trochoid that its shaper leaves; of a rack's tooth where the shaper leaves none.
RootFactors ring_root(const LoadedMesh& mesh, const RackTool& tool) {
  const ShiftedPair& pair = mesh.cut.pair;
  const double middle = pair.teeth_2 / 2.0 + pair.shift_2;
  const ToothForm form{.teeth = std::llround(pair.teeth_2),
                       .internal = true,
                       .profile_shift = pair.shift_2,
                       .tip_radius = mesh.cut.tip_diameter_2 / 2.0,
                       .root_radius = middle + tool.dedendum,
                       .fillet_radius = tool.root_radius,
                       .shaper_teeth = mesh.shaper_teeth};
  if (const auto section = critical_ring_section(form)) return section->factors;
  return din3990_ring_root_factors(form.root_radius - form.tip_radius, tool);
}

RootShape root_shape(const LoadedMesh& mesh, std::size_t which) {
  const CutPair& cut = mesh.cut;
  const RackTool tool{mesh.cutter_addendum[which], mesh.cutter_tip_radius[which]};
  if (which == 1 && cut.pair.kind == MeshKind::kInternal) {
    const RootFactors ring = ring_root(mesh, tool);
    return {ring, ring.concentration};
  }
  const double teeth = which == 0 ? cut.pair.teeth_1 : cut.pair.teeth_2;
  const double shift = which == 0 ? cut.pair.shift_1 : cut.pair.shift_2;
  const double tip = which == 0 ? cut.tip_diameter_1 : cut.tip_diameter_2;
  const double overlap = std::min(mesh.contact_ratio, 2.0);
  return {din3990_root_factors(teeth, shift, tip, 1.0, tool),
          din3990_root_factors(teeth, shift, tip, overlap, tool).concentration};
}

/// DIN 3990 takes the tangential force at the reference circle: the same normal force, F_t = F
/// cos(alpha)/cos(alpha_w) of the one at the working circle.
double reference_force_N(const LoadedMesh& mesh, double force_N) {
  return force_N * (kReferenceCosine / std::cos(mesh.cut.working_angle_rad));
}

ToothStress against(const LifeCurve& life, double cycles, double stress_MPa) {
  return {stress_MPa, life.static_MPa, life.at_MPa(cycles)};
}

/// An external tooth as it is cut; of a ring's the factor asks for the module alone.
Rim rim_of(const LoadedMesh& mesh, std::size_t which, double rim_mm) {
  const CutPair& cut = mesh.cut;
  const bool internal = which == 1 && cut.pair.kind == MeshKind::kInternal;
  const double teeth = which == 0 ? cut.pair.teeth_1 : cut.pair.teeth_2;
  const double shift = which == 0 ? cut.pair.shift_1 : cut.pair.shift_2;
  const double tip = which == 0 ? cut.tip_diameter_1 : cut.tip_diameter_2;
  // Of a ring the tip lies inside the root.
  const double middle = teeth / 2.0 + shift;
  const double depth = mesh.cutter_addendum[which];
  const double height = internal ? middle + depth - tip / 2.0 : tip / 2.0 - middle + depth;
  return {internal, rim_mm, mesh.module_mm, height * mesh.module_mm};
}

/// docs/derivations/strength.md eq. (4), (5).
ToothStress root_stress(const StrengthCase& strength, const LoadedMesh& mesh, std::size_t which,
                        double force_N, double rim_factor) {
  const LoadFactors& factors = strength.factors;
  const RootShape shape = root_shape(mesh, which);
  const double nominal_MPa =
      din3990_root_stress_MPa(reference_force_N(mesh, force_N), mesh.face_width_mm, mesh.module_mm,
                              shape.tip) *
      contact_ratio_factor(mesh.contact_ratio);
  const double stress_MPa = nominal_MPa * factors.application * factors.dynamic *
                            factors.load_sharing * factors.face_load_root * rim_factor;
  const double share = mesh.bends_both_ways[which] ? factors.alternating_bending : 1.0;
  return against(
      root_life(strength.material_of(mesh.gears[which]), shape.working_concentration, share),
      strength.cycles, stress_MPa);
}

/// The same pair of flanks seen from its other gear; the ring's point is the planet's.
double flank_factor(const LoadedMesh& mesh, ContactPair pair, std::size_t which) {
  if (which == 0 || pair.internal) {
    return single_contact_factor(pair, mesh.cut.tip_diameter_1, mesh.cut.tip_diameter_2);
  }
  std::swap(pair.teeth_1, pair.teeth_2);
  return single_contact_factor(pair, mesh.cut.tip_diameter_2, mesh.cut.tip_diameter_1);
}

/// docs/derivations/strength.md eq. (8)...(10).
ToothStress flank_stress(const StrengthCase& strength, const LoadedMesh& mesh, std::size_t which,
                         double force_N) {
  const LoadFactors& factors = strength.factors;
  const GearMaterial& first = strength.material_of(mesh.gears[0]);
  const GearMaterial& second = strength.material_of(mesh.gears[1]);
  const ShiftedPair& teeth = mesh.cut.pair;
  const ContactPair pair{teeth.kind == MeshKind::kInternal,
                         teeth.teeth_1,
                         teeth.teeth_2,
                         teeth.teeth_1 * mesh.module_mm,
                         mesh.face_width_mm,
                         mesh.cut.working_angle_rad,
                         mesh.contact_ratio};
  const double elasticity =
      elasticity_factor(first.young_MPa, first.poisson, second.young_MPa, second.poisson);
  const double stress_MPa = contact_stress_MPa(pair, reference_force_N(mesh, force_N), elasticity) *
                            flank_factor(mesh, pair, which) *
                            std::sqrt(factors.application * factors.dynamic * factors.load_sharing *
                                      factors.face_load_flank);
  return against(flank_life(which == 0 ? first : second), strength.cycles, stress_MPa);
}

}  // namespace

const GearMaterial& StrengthCase::material_of(std::string_view gear) const {
  const auto own = own_material.find(gear);
  return own == own_material.end() ? material : own->second;
}

std::optional<double> rim_factor_of(const StrengthCase& strength, const LoadedMesh& mesh,
                                    std::size_t which) {
  const auto stated = strength.rim_mm.find(mesh.gears[which]);
  if (stated == strength.rim_mm.end()) return 1.0;
  return rim_factor(rim_of(mesh, which, stated->second));
}

double sun_torque_Nm(const GearTrain& train, double torque_Nm, TorqueSide side) {
  const double magnitude_Nm = std::abs(torque_Nm);
  return side == TorqueSide::kMotor ? magnitude_Nm : magnitude_Nm / std::abs(reduction(train));
}

std::vector<ToothLoad> tooth_loads(const StrengthCase& strength, double torque_Nm) {
  std::vector<ToothLoad> loads;
  for (const LoadedMesh& mesh : loaded_train(strength.train).meshes) {
    const double force_N = mesh.force_per_sun_torque_N_Nm * torque_Nm;
    for (std::size_t which : {0u, 1u}) {
      const double rim = rim_factor_of(strength, mesh, which).value_or(1.0);
      loads.push_back({mesh.gears[which], mesh.name, mesh.cutter_tip_radius[which], rim, force_N,
                       root_stress(strength, mesh, which, force_N, rim),
                       flank_stress(strength, mesh, which, force_N)});
    }
  }
  return loads;
}

bool has_demanded_safety(const StrengthCase& strength, const std::vector<ToothLoad>& loads) {
  return std::all_of(loads.begin(), loads.end(), [&](const ToothLoad& load) {
    return load.root.least_safety() >= strength.demanded_root_safety &&
           load.flank.least_safety() >= strength.demanded_flank_safety;
  });
}

}  // namespace torquewright::gearbox
