// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/gear_cutters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "gearbox/constraints/cut_ring.hpp"
#include "gearbox/constraints/hob_reach.hpp"

namespace torquewright::gearbox {
namespace {

GearCutter hob_of(const CutGear& gear, const Cutters& cutters) {
  return {.gear = gear.name,
          .tip_radius = cutters.hob_tip_radius.value_or(kHobTipRadius),
          .addendum = cutters.hob_depth(),
          .is_radius_assumed = !cutters.hob_tip_radius,
          .is_addendum_assumed = !cutters.hob_addendum};
}

/// An assumed rounding leaves the mate its involute.
void sharpen(GearCutter& cutter, const std::optional<double>& largest) {
  if (!cutter.is_radius_assumed || !largest) return;
  cutter.tip_radius = std::clamp(*largest, 0.0, cutter.tip_radius);
}

/// It leaves the involutes that the planet's rings touch.
GearCutter hob_of_planet(const CutTrain& train, std::size_t planet) {
  GearCutter cutter = hob_of(train.gears[planet], train.train.cutters);
  for (const CutMesh& mesh : std::span(train.meshes).subspan(1)) {
    if (mesh.gear_1 != planet) continue;
    sharpen(cutter, largest_hob_tip_radius(planet_in_ring(train, mesh)));
  }
  return cutter;
}

GearCutter shaper_of_ring(const CutTrain& train, const CutMesh& mesh) {
  const Cutters& cutters = train.train.cutters;
  const CutGear& planet = train.gears[mesh.gear_1];
  GearCutter cutter{.gear = train.gears[mesh.gear_2].name,
                    .tip_radius = cutters.shaper_tip_radius.value_or(kRingFilletRadius),
                    .addendum = cutters.shaper_depth(),
                    .shaper_teeth = cutters.shaper_teeth.value_or(planet.teeth),
                    .is_radius_assumed = !cutters.shaper_tip_radius,
                    .are_teeth_assumed = !cutters.shaper_teeth,
                    .is_addendum_assumed = !cutters.shaper_addendum};
  const auto shaper = shaper_of(train, mesh);
  if (!shaper) return cutter;
  cutter.tip_radius = std::min(cutter.tip_radius, full_shaper_rounding(*shaper));
  sharpen(cutter, largest_shaper_tip_radius(*shaper, planet_in_ring(train, mesh),
                                            planet.tip_diameter / 2.0));
  return cutter;
}

std::string_view if_assumed(bool assumed) { return assumed ? " (assumed)" : ""; }

}  // namespace

std::vector<GearCutter> gear_cutters(const CutTrain& train) {
  std::vector<GearCutter> list{hob_of(train.gears.front(), train.train.cutters)};
  const std::span rings = std::span(train.meshes).subspan(1);
  for (std::size_t gear = 1; !train.gears[gear].internal; ++gear) {
    list.push_back(hob_of_planet(train, gear));
  }
  if (const auto largest = largest_hob_tip_radii(train, train.meshes.front())) {
    sharpen(list[0], (*largest)[0]);
    sharpen(list[1], (*largest)[1]);
  }
  for (const CutMesh& mesh : rings) list.push_back(shaper_of_ring(train, mesh));
  return list;
}

std::string cutter_sentence(const std::vector<GearCutter>& cutters) {
  std::string text;
  for (const GearCutter& cutter : cutters) {
    const bool is_shaper = cutter.shaper_teeth > 0;
    text += fmt::format("{}{} {:.3g}{}", text.empty() ? "" : ", ", cutter.gear, cutter.tip_radius,
                        if_assumed(cutter.is_radius_assumed));
    if (!is_shaper) continue;
    text += fmt::format(" of a shaper of {} teeth{}", cutter.shaper_teeth,
                        if_assumed(cutter.are_teeth_assumed));
  }
  const GearCutter& hob = cutters.front();
  const GearCutter& shaper = cutters.back();
  return fmt::format("tip radii of the cutters in modules: {}; addenda: hob {:g}{}, shaper {:g}{}",
                     text, hob.addendum, if_assumed(hob.is_addendum_assumed), shaper.addendum,
                     if_assumed(shaper.is_addendum_assumed));
}

}  // namespace torquewright::gearbox
