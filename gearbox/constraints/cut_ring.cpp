// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/cut_ring.hpp"

namespace torquewright::gearbox {

PlanetInRing planet_in_ring(const CutTrain& train, const CutMesh& mesh) {
  const CutGear& planet = train.gears[mesh.gear_1];
  const CutGear& ring = train.gears[mesh.gear_2];
  return {planet.count(),
          planet.shift,
          ring.count(),
          ring.tip_diameter / 2.0,
          train.centre_mm / ring.module_mm,
          train.train.cutters.hob_depth()};
}

std::optional<ShaperAtDepth> shaper_of(const CutTrain& train, const CutMesh& mesh) {
  const CutGear& ring = train.gears[mesh.gear_2];
  const std::int64_t teeth =
      train.train.cutters.shaper_teeth.value_or(train.gears[mesh.gear_1].teeth);
  return shaper_at_depth(
      {ring.count(), ring.shift, ring.root_diameter() / 2.0, static_cast<double>(teeth)});
}

}  // namespace torquewright::gearbox
