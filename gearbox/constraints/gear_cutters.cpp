// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/gear_cutters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "gearbox/constraints/cut_ring.hpp"

namespace torquewright::gearbox {
namespace {

GearCutter hob_of(const CutGear& gear, const Cutters& cutters) {
  return {gear.name, cutters.hob_tip_radius.value_or(kHobTipRadius), 0, !cutters.hob_tip_radius,
          false};
}

GearCutter hob_of_planet(const CutTrain& train, const CutMesh& mesh) {
  GearCutter cutter = hob_of(train.gears[mesh.gear_1], train.train.cutters);
  if (!cutter.is_radius_assumed) return cutter;
  if (const auto largest = largest_hob_tip_radius(planet_in_ring(train, mesh))) {
    cutter.tip_radius = std::clamp(*largest, 0.0, kHobTipRadius);
  }
  return cutter;
}

GearCutter shaper_of_ring(const CutTrain& train, const CutMesh& mesh) {
  const Cutters& cutters = train.train.cutters;
  const CutGear& planet = train.gears[mesh.gear_1];
  GearCutter cutter{train.gears[mesh.gear_2].name,
                    cutters.shaper_tip_radius.value_or(kRingFilletRadius),
                    cutters.shaper_teeth.value_or(planet.teeth), !cutters.shaper_tip_radius,
                    !cutters.shaper_teeth};
  const auto shaper = shaper_of(train, mesh);
  if (!shaper) return cutter;
  cutter.tip_radius = std::min(cutter.tip_radius, full_shaper_rounding(*shaper));
  const auto largest =
      largest_shaper_tip_radius(*shaper, planet_in_ring(train, mesh), planet.tip_diameter / 2.0);
  if (cutter.is_radius_assumed && largest) {
    cutter.tip_radius = std::clamp(*largest, 0.0, cutter.tip_radius);
  }
  return cutter;
}

}  // namespace

std::vector<GearCutter> gear_cutters(const CutTrain& train) {
  std::vector<GearCutter> list{hob_of(train.gears.front(), train.train.cutters)};
  const std::span rings = std::span(train.meshes).subspan(1);
  for (const CutMesh& mesh : rings) list.push_back(hob_of_planet(train, mesh));
  for (const CutMesh& mesh : rings) list.push_back(shaper_of_ring(train, mesh));
  return list;
}

std::string cutter_sentence(const std::vector<GearCutter>& cutters) {
  std::string text;
  for (const GearCutter& cutter : cutters) {
    const bool is_shaper = cutter.shaper_teeth > 0;
    text += fmt::format("{}{} {:.3g}{}", text.empty() ? "" : ", ", cutter.gear, cutter.tip_radius,
                        cutter.is_radius_assumed ? " (assumed)" : "");
    if (!is_shaper) continue;
    text += fmt::format(" of a shaper of {} teeth{}", cutter.shaper_teeth,
                        cutter.are_teeth_assumed ? " (assumed)" : "");
  }
  return "tip radii of the cutters in modules: " + text;
}

}  // namespace torquewright::gearbox
