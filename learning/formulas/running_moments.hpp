// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>

namespace torquewright::learning {

/// Mean and variance of vectors as they come, without keeping them (Chan, Golub and LeVeque 1979).
/// What came long ago may count less: no more than `memory` vectors in all.
class RunningMoments {
 public:
  explicit RunningMoments(Eigen::Index size,
                          double memory = std::numeric_limits<double>::infinity());

  /// Adds the columns of a matrix (size x vectors).
  void add(const Eigen::Ref<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>& vectors);

  double count() const { return count_; }
  const Eigen::VectorXd& mean() const { return mean_; }
  /// Mean square of the distance to the mean; 1 as long as nothing came.
  Eigen::VectorXd variance() const;
  /// Square root of the variance, but nowhere below `least`.
  Eigen::VectorXd deviation(double least) const;

  /// All that it remembers: count, mean, sums of squares.
  Eigen::VectorXd state() const;
  /// Requires a state of its size.
  void set_state(const Eigen::Ref<const Eigen::VectorXd>& state);

 private:
  double memory_;
  double count_ = 0.0;
  Eigen::VectorXd mean_;
  Eigen::VectorXd squares_;  // sum of squared distances to the mean
  Eigen::VectorXd here_mean_;
  Eigen::VectorXd here_squares_;
};

}  // namespace torquewright::learning
