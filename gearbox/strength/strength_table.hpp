// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/strength/tooth_load.hpp"

namespace torquewright::gearbox {

/// The same gearbox in other sizes, where its own are not known.
struct StrengthVariants {
  std::vector<StrengthCase> cases;  ///< Cases by module, then by face width.
  /// A sentence for each module without teeth, or whose ring does not fit into the room.
  std::vector<std::string> left_out;
};

/// The single stage of the same ratio and planet count with the most teeth that the module leaves
/// room for: the ring's blank within `ring_space_mm`, planets clear of each other, equally spaced.
/// Empty where there is none.
std::vector<std::int64_t> stage_with_most_teeth(const GearTrain& stage, double module_mm,
                                                double ring_space_mm);

/// Every module with every face width (of all layers). Modules of a single stage bring their own
/// teeth, those above; teeth of a 3K train stay, and a module that makes its rings larger than
/// `ring_space_mm` (0: not known) is left out. An empty list stands for the case's own value.
StrengthVariants strength_variants(const StrengthCase& strength,
                                   const std::vector<double>& modules_mm,
                                   const std::vector<double>& face_widths_mm, double ring_space_mm);

}  // namespace torquewright::gearbox
