// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {

/// What cuts one gear: the one value that drawing, strength and report use.
struct GearCutter {
  std::string_view gear;
  double tip_radius = 0.0;        ///< In modules.
  double addendum = 0.0;          ///< How deep it cuts below the middle line, likewise.
  std::int64_t shaper_teeth = 0;  ///< 0: a hob.
  bool is_radius_assumed = false;
  bool are_teeth_assumed = false;
  bool is_addendum_assumed = false;
};

/// The cutter of each gear, in the topology's order: as stated, else ISO 53 profile A and a shaper
/// of as many teeth as the planet has, rounded only as much as leaves the mate's tip its involute.
std::vector<GearCutter> gear_cutters(const CutTrain& train);

/// "hob with tip radius 0.38 (assumed)" and so on, in modules.
std::string cutter_sentence(const std::vector<GearCutter>& cutters);

}  // namespace torquewright::gearbox
