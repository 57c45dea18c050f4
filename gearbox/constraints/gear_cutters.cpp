// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/gear_cutters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearbox/constraints/made_train.hpp"

namespace torquewright::gearbox {
namespace {

GearCutter hob_of_sun(const MadeTrain& train, const Cutters& cutters) {
  return {train.sun.name, cutters.hob_tip_radius.value_or(kHobTipRadius), 0,
          !cutters.hob_tip_radius, false};
}

GearCutter hob_of_planet(const MadeTrain& train, const MadeLayer& layer, const Cutters& cutters) {
  GearCutter cutter{layer.planet.name, kHobTipRadius, 0, !cutters.hob_tip_radius, false};
  if (cutters.hob_tip_radius) {
    cutter.tip_radius = *cutters.hob_tip_radius;
  } else if (const auto largest = largest_hob_tip_radius(planet_in_ring(train, layer))) {
    cutter.tip_radius = std::clamp(*largest, 0.0, kHobTipRadius);
  }
  return cutter;
}

GearCutter shaper_of_ring(const MadeTrain& train, const MadeLayer& layer, const Cutters& cutters) {
  GearCutter cutter{layer.ring.name, cutters.shaper_tip_radius.value_or(kRingFilletRadius),
                    cutters.shaper_teeth.value_or(layer.planet.teeth), !cutters.shaper_tip_radius,
                    !cutters.shaper_teeth};
  const auto shaper = shaper_of(layer, cutters);
  if (!shaper) return cutter;
  cutter.tip_radius = std::min(cutter.tip_radius, full_shaper_rounding(*shaper));
  const auto largest = largest_shaper_tip_radius(*shaper, planet_in_ring(train, layer),
                                                 layer.planet.tip_diameter / 2.0);
  if (cutter.is_radius_assumed && largest) {
    cutter.tip_radius = std::clamp(*largest, 0.0, cutter.tip_radius);
  }
  return cutter;
}

}  // namespace

std::vector<GearCutter> gear_cutters(const GearTrain& train) {
  const auto parts = made(train);
  if (!parts) return {};
  std::vector<GearCutter> list{hob_of_sun(*parts, train.cutters)};
  for (const MadeLayer& layer : parts->layers) {
    list.push_back(hob_of_planet(*parts, layer, train.cutters));
  }
  for (const MadeLayer& layer : parts->layers) {
    list.push_back(shaper_of_ring(*parts, layer, train.cutters));
  }
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
