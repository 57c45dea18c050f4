// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/made_train.hpp"

#include <algorithm>

#include "gearbox/teeth/profile_shift.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {

std::optional<MadeTrain> made(const GearTrain& train) {
  const auto& z = train.teeth;
  const auto& x = train.shifts;
  const auto real = [&z](std::size_t gear) { return static_cast<double>(z[gear]); };
  const ShiftedPair first{MeshKind::kExternal, real(0), real(1), x[0], x[1]};
  const auto angle = working_angle_rad(first);
  if (!angle) return std::nullopt;
  MadeTrain result;
  result.planet_count = train.planet_count;
  result.module_mm = io::exact(train.module_mm);
  result.centre = centre_distance(first, *angle);
  result.is_shifted = std::any_of(x.begin(), x.end(), [](double shift) { return shift != 0.0; });
  const double increment = centre_increment(first, result.centre);
  result.sun = {"sun", z[0], x[0], tip_diameter_keeping_clearance(real(0), x[1], increment)};
  const double planet_1_tip = tip_diameter_planet_1(real(1), x[1], x[0], increment);
  const auto ring = [&](std::string_view name, std::size_t gear) {
    return MadeGear{name, z[gear], x[gear], tip_diameter_ring(real(gear), x[gear])};
  };
  if (train.topology == "3k") {
    const MadeGear planet_2{"planet_2", z[2], x[2], tip_diameter_external(real(2), x[2])};
    result.layers = {{"layer_1",
                      "planet_1_fixed_ring",
                      {"planet_1", z[1], x[1], planet_1_tip},
                      ring("fixed_ring", 3)},
                     {"layer_2", "planet_2_output_ring", planet_2, ring("output_ring", 4)}};
  } else {
    result.layers = {
        {"layer_1", "planet_ring", {"planet", z[1], x[1], planet_1_tip}, ring("ring", 2)}};
  }
  return result;
}

PlanetInRing planet_in_ring(const MadeTrain& train, const MadeLayer& layer) {
  return {layer.planet.count(), layer.planet.shift, layer.ring.count(),
          layer.ring.tip_diameter / 2.0, train.centre};
}

std::optional<ShaperAtDepth> shaper_of(const MadeLayer& layer, const Cutters& cutters) {
  const double ring = layer.ring.count();
  const std::int64_t teeth = cutters.shaper_teeth.value_or(layer.planet.teeth);
  return shaper_at_depth({ring, layer.ring.shift, ring / 2.0 + kDedendum + layer.ring.shift,
                          static_cast<double>(teeth)});
}

}  // namespace torquewright::gearbox
