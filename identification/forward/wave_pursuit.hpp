// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::identification {

/// Products of a target, of columns that stand beside it, and of waves (sine and cosine of each):
/// the target first, then the columns, then the waves pair by pair.
class WavePursuit {
 public:
  /// `beside`: how many columns stand between the target and the waves.
  explicit WavePursuit(Eigen::Index beside, std::size_t waves);

  /// Adds a row: the target, the columns, then sine and cosine of each wave.
  void add(const Eigen::VectorXd& row);

  /// Waves by their place, the one first that takes most of the target's power on top of the
  /// columns and of the waves before it, each refitted beside all others. Ends at `most`, or where
  /// no wave takes `least_share` of the power that the columns leave.
  std::vector<std::size_t> strongest(std::size_t most, double least_share) const;

 private:
  Eigen::Index beside_;
  std::size_t waves_;
  Eigen::MatrixXd products_;  ///< Lower triangle.
};

}  // namespace torquewright::identification
