// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace torquewright::gearbox {

/// For a range of alpha_min, the least minima that make a design the optimum: any minima that are
/// at least one of these (and at most the design's own teeth) do.
struct OptimalWhen {
  double clearance_above_rad = 0.0;  ///< alpha_min > this ...
  double clearance_up_to_rad = 0.0;  ///< ... and <= this.
  bool from_zero = false;            ///< The range starts at alpha_min = 0, that included.
  /// By free gear; 0: no minimum needed. Empty: no minima make it the optimum in this range.
  std::vector<std::vector<std::int64_t>> least_minima;
};

/// A design that beats the one in question unless minima or clearance exclude it.
struct BetterDesign {
  std::vector<std::int64_t> free_teeth;
  double clearance_rad;
};

/// For which alpha_min and minima a design is the optimum: every better design must have fewer
/// teeth than a minimum in one gear, or less clearance than alpha_min. Ranges of alpha_min with the
/// same answer are one range.
std::vector<OptimalWhen> optimal_when(const std::vector<std::int64_t>& free_teeth,
                                      double clearance_rad, std::vector<BetterDesign> better);

}  // namespace torquewright::gearbox
