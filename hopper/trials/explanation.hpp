// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hopper/trials/run_trials.hpp"

namespace torquewright::hopper {

using TrialOutcomes = std::vector<std::optional<TrialOutcome>>;

/// Mean and standard deviation of the rotation that was missing at touch-down, in rad, of those
/// trials that landed.
struct RotationSpread {
  std::size_t landed = 0;
  double mean_rad = 0.0;
  double deviation_rad = 0.0;
};

/// Returns that spread; none where fewer than two trials landed.
std::optional<RotationSpread> rotation_spread(const TrialOutcomes& outcomes);

/// What trials that differ in one thing alone come to.
struct CauseEffect {
  std::string cause;  ///< As causes_of() names it.
  TrialCounts counts;
  std::optional<RotationSpread> rotation;
  /// Variance of the missing rotation against that of the trials that differ in everything; none
  /// where one of the two is not known or nothing varies. Shares of causes that act together need
  /// not add up to 1.
  std::optional<double> variance_share;
};

/// Returns what one cause alone does, beside the trials that differ in everything.
CauseEffect effect_of_cause(const std::string& cause, const TrialOutcomes& alone,
                            const TrialOutcomes& all);

/// How many trials landed with so much rotation missing, in degrees; negative: turned too far.
struct RotationBin {
  double from_deg = 0.0;
  double until_deg = 0.0;
  std::size_t succeeded = 0;
  std::size_t failed = 0;
};

/// Returns the histogram of missing rotation over trials that landed: bins of 1, 2, 5, 10, 20, 50
/// ... degrees, the narrowest of which 16 suffice, without gaps. Empty where none landed.
std::vector<RotationBin> rotation_bins(const TrialOutcomes& outcomes);

}  // namespace torquewright::hopper
