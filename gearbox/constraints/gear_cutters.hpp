// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {

/// The cutter of one gear: the one value that drawing, strength and report use.
struct GearCutter {
  std::string_view gear;
  double tip_radius = 0.0;        ///< Tip radius in modules.
  double addendum = 0.0;          ///< Depth of the cut below the middle line, in modules.
  std::int64_t shaper_teeth = 0;  ///< Teeth of a shaper; 0: a hob.
  bool is_radius_assumed = false;
  bool are_teeth_assumed = false;
  bool is_addendum_assumed = false;
};

/// Returns the cutter of each gear, in the topology's order: as stated, else ISO 53 profile A and a
/// shaper of as many teeth as the planet has, rounded only as much as leaves the mate's tip its
/// involute.
std::vector<GearCutter> gear_cutters(const CutTrain& train);

/// Returns a sentence: "hob with tip radius 0.38 (assumed)" and so on, in modules.
std::string cutter_sentence(const std::vector<GearCutter>& cutters);

}  // namespace torquewright::gearbox
