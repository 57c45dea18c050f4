// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/cut_train.hpp"

#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {
namespace {

constexpr std::size_t kSun = 0;
constexpr std::size_t kPlanet1 = 1;

/// Gears by name, kind and layer; shifts and tips follow.
CutTrain named_parts(const GearTrain& train) {
  const TrainParts& parts = train_parts(train.topology);
  CutTrain cut;
  cut.train = train;
  for (const MeshedGears& mesh : parts.meshes) {
    cut.meshes.push_back({mesh.name, mesh.gear_1, mesh.gear_2, {}, {}});
  }
  for (std::size_t i = 0; i < parts.gears.size(); ++i) {
    CutGear gear{parts.gears[i], parts.is_ring(i), parts.gear_layers[i]};
    gear.teeth = train.teeth[i];
    gear.shift = i < train.shifts.size() ? train.shifts[i] : 0.0;
    gear.module_mm = train.module_of_layer_mm(gear.layer);
    gear.root_depth = gear.internal ? train.cutters.shaper_depth() : train.cutters.hob_depth();
    cut.gears.push_back(gear);
  }
  return cut;
}

ShiftedPair pair_of(const CutTrain& parts, const CutMesh& mesh) {
  const CutGear& first = parts.gears[mesh.gear_1];
  const CutGear& second = parts.gears[mesh.gear_2];
  return {second.internal ? MeshKind::kInternal : MeshKind::kExternal, first.count(),
          second.count(), first.shift, second.shift};
}

void set_tips(CutTrain& parts, double increment) {
  CutGear& sun = parts.gears[kSun];
  CutGear& planet_1 = parts.gears[kPlanet1];
  for (CutGear& gear : parts.gears) {
    gear.tip_diameter = gear.internal ? tip_diameter_ring(gear.count(), gear.shift)
                                      : tip_diameter_external(gear.count(), gear.shift);
  }
  sun.tip_diameter = tip_diameter_keeping_clearance(sun.count(), planet_1.shift, increment);
  planet_1.tip_diameter =
      tip_diameter_planet_1(planet_1.count(), planet_1.shift, sun.shift, increment);
}

void close_ring(const CutTrain& parts, CutMesh& mesh) {
  const CutGear& planet = parts.gears[mesh.gear_1];
  const CutGear& ring = parts.gears[mesh.gear_2];
  const ShiftedPair pair = pair_of(parts, mesh);
  if (pair.teeth_2 <= pair.teeth_1) return;
  const double centre = parts.centre_mm / ring.module_mm;
  const auto angle = working_angle_at_rad(teeth_between_centres(pair), centre);
  const auto closing = closing_shift(pair, centre);
  if (!angle || !closing) return;
  mesh.closing_ring_shift = planet.shift + *closing;
  mesh.cut = CutPair{pair, *angle, planet.tip_diameter, ring.tip_diameter};
}

}  // namespace

double CutGear::root_diameter() const {
  return middle_diameter() + (internal ? 2.0 : -2.0) * root_depth;
}

double CutGear::base_diameter() const { return count() * kReferenceCosine; }

std::optional<CutTrain> cut_train(const GearTrain& train) {
  CutTrain parts = named_parts(train);
  const ShiftedPair first = pair_of(parts, parts.meshes.front());
  const auto angle = working_angle_rad(first);
  if (!angle) return std::nullopt;
  const double centre = centre_distance(first, *angle);
  parts.centre_mm = train.module_mm * centre;
  set_tips(parts, centre_increment(first, centre));
  for (CutMesh& mesh : parts.meshes) {
    if (parts.gears[mesh.gear_2].internal) {
      close_ring(parts, mesh);
    } else {
      mesh.cut = CutPair{first, *angle, parts.gears[mesh.gear_1].tip_diameter,
                         parts.gears[mesh.gear_2].tip_diameter};
    }
  }
  return parts;
}

std::optional<std::vector<double>> coaxial_shifts(const GearTrain& of_sun_and_planets) {
  const auto parts = cut_train(of_sun_and_planets);
  if (!parts) return std::nullopt;
  std::vector<double> shifts;
  for (const CutGear& gear : parts->gears) shifts.push_back(gear.shift);
  for (const CutMesh& mesh : parts->meshes) {
    if (!parts->gears[mesh.gear_2].internal) continue;
    if (mesh.closing_ring_shift) shifts[mesh.gear_2] = *mesh.closing_ring_shift;
  }
  return shifts;
}

}  // namespace torquewright::gearbox
