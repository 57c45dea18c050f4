// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace torquewright::gearbox {

/// The least minima that make a design the optimum, for a range of alpha_min: any minima that are
/// at least one of these (and at most the design's own teeth) do.
struct OptimalWhen {
  double clearance_above_rad = 0.0;  ///< Lower end of the range: alpha_min is greater than this.
  double clearance_up_to_rad = 0.0;  ///< Upper end of the range, included.
  bool from_zero = false;            ///< The range starts at alpha_min = 0, which is included.
  /// Least numbers of teeth by free gear; 0: no minimum needed. Empty: no minima make it the
  /// optimum in this range.
  std::vector<std::vector<std::int64_t>> least_minima;
};

/// Teeth and clearance of a design, which minima and alpha_min are compared with.
struct TeethAndClearance {
  std::vector<std::int64_t> free_teeth;
  double clearance_rad;
};

/// The designs that beat one design. Only those are kept that are hardest to exclude: minima and an
/// alpha_min that exclude them exclude all others.
class BetterDesigns {
 public:
  explicit BetterDesigns(TeethAndClearance own) : own_(std::move(own)) {}

  void add(TeethAndClearance better);

  /// Returns for which alpha_min and minima the design is the optimum: every better one must have
  /// fewer teeth than a minimum in one gear, or less clearance than alpha_min. Ranges of alpha_min
  /// with the same answer are one range, in the order of alpha_min.
  std::vector<OptimalWhen> optimal_when() const;

 private:
  TeethAndClearance own_;
  std::vector<TeethAndClearance> hardest_;
};

}  // namespace torquewright::gearbox
