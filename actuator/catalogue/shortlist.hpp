// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/mor/need.hpp"

namespace torquewright::actuator {

/// What a drive is looked for.
struct Wanted {
  std::vector<Need> needs;              ///< Each of them, at the peak rating.
  std::optional<double> continuous_Nm;  ///< That may last, at rest.
  std::optional<double> mass_below_kg;  ///< Of all of it.
  struct Ratios {
    double least;
    double greatest;
  };
  std::optional<Ratios> ratios;  ///< Of which the best one is taken; absent: the drive's own.
};

/// How one drive does.
struct Suitability {
  bool fits = false;
  bool is_unknown =
      false;  ///< All that is known would do; what its document does not state decides.
  /// Least distance of what is wanted to what the drive has, over what is wanted; negative: so much
  /// is missing. Empty where the drive does not state what decides.
  std::optional<double> margin_share;
  double ratio = 1.0;
  std::vector<std::string> reasons;  ///< Why it does not fit, a clause each.
};

/// Requires at least one need, torque and speed not both zero. Ratios are tried in steps of 2 %.
Suitability suitability(const Actuator& actuator, const Wanted& wanted);

}  // namespace torquewright::actuator
