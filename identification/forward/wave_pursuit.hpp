// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::identification {

/// Finds the strongest waves by pursuit, from sums of products of a target, of columns that stand
/// beside it, and of waves (sine and cosine of each).
class WavePursuit {
 public:
  /// `beside` is the number of columns between the target and the waves.
  explicit WavePursuit(Eigen::Index beside, std::size_t waves);

  /// Adds a sample: the target, the columns, then sine and cosine of each wave.
  void add(const Eigen::VectorXd& row);

  /// Returns indices of waves, the strongest first: each takes most of the target's power on top of
  /// the columns and of the waves before it, all refitted. Ends at `most` waves, or where none
  /// takes `least_share` of the power that the columns leave.
  std::vector<std::size_t> strongest(std::size_t most, double least_share) const;

 private:
  Eigen::Index beside_;
  std::size_t waves_;
  Eigen::MatrixXd products_;  ///< Sums of products; lower triangle.
};

}  // namespace torquewright::identification
