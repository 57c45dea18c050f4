// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/tolerances/built_train.hpp"

namespace torquewright::gearbox {

/// Between these lies a quantity, whatever lies within its parts' limits.
struct WorstCase {
  double least = 0.0;
  double greatest = 0.0;
  bool is_attained = true;  ///< By parts at their limits; else a bound beyond.
};

struct MeshWorstCase {
  WorstCase backlash_mm;
  WorstCase contact_ratio;
  WorstCase tip_clearance_mm;  ///< Its greatest is a bound.
};

/// A mesh's quantities grow or fall with each dimension whatever the others are, so that the worst
/// parts stand in a corner.
MeshWorstCase worst_case_of_mesh(const ToleratedTrain& train, std::size_t mesh);

/// Backlash of the output, sun and held ring at rest [rad]: a sum of what each dimension gives, all
/// of them straight lines but that of the centre distance, which is bounded by its slope where it
/// turns.
WorstCase worst_case_of_output_rad(const ToleratedTrain& train);

/// Share of each dimension in the variance of the output's backlash, by its slope where parts are
/// at the middle of their limits; of one planet. All sum to 1, or are 0 where nothing varies.
std::vector<double> variance_shares(const ToleratedTrain& train);

/// The standard deviation that these slopes give for a distribution whose variance is so many
/// squares of the limits' width (even: 1/12) [rad].
double linear_deviation_rad(const ToleratedTrain& train, double variance_per_width_squared);

}  // namespace torquewright::gearbox
