// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/tolerances/part_limits.hpp"

namespace torquewright::cli {

/// What the command line says of tolerances.
struct StatedLimits {
  std::optional<double> centre_distance_mm;  ///< +-
  std::vector<std::string> tooth_thickness;  ///< "-0.06:-0.03", or of one gear "sun=-0.05:-0.02".
  std::optional<double> profile_shift;       ///< +-, in modules.
  std::optional<double> tip_diameter_mm;     ///< So much less, of rings so much more.
};

/// Puts them in the place of usual limits. Throws SpecError where one says what is no limit.
void state_limits(const StatedLimits& stated, const gearbox::CutTrain& train,
                  std::vector<gearbox::PartLimit>& limits);

}  // namespace torquewright::cli
