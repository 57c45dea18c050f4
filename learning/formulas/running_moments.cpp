// SPDX-License-Identifier: Apache-2.0
#include "learning/formulas/running_moments.hpp"

#include <algorithm>

namespace torquewright::learning {

RunningMoments::RunningMoments(Eigen::Index size, double memory)
    : memory_(memory),
      mean_(Eigen::VectorXd::Zero(size)),
      squares_(Eigen::VectorXd::Zero(size)),
      here_mean_(size),
      here_squares_(size) {}

// Sums of squares are of distances to the mean of these very vectors: no two large numbers are
// subtracted.
void RunningMoments::add(
    const Eigen::Ref<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>& vectors) {
  const auto here = static_cast<double>(vectors.cols());
  if (here == 0.0) return;
  here_mean_.setZero();
  for (Eigen::Index j = 0; j < vectors.cols(); ++j) here_mean_ += vectors.col(j).cast<double>();
  here_mean_ /= here;
  here_squares_.setZero();
  for (Eigen::Index j = 0; j < vectors.cols(); ++j) {
    here_squares_ += (vectors.col(j).cast<double>() - here_mean_).cwiseAbs2();
  }
  const double all = count_ + here;
  squares_ += here_squares_ + (here_mean_ - mean_).cwiseAbs2() * (count_ * here / all);
  mean_ += (here_mean_ - mean_) * (here / all);
  count_ = std::min(all, memory_);
  squares_ *= count_ / all;
}

Eigen::VectorXd RunningMoments::variance() const {
  if (count_ == 0.0) return Eigen::VectorXd::Ones(mean_.size());
  return squares_ / count_;
}

Eigen::VectorXd RunningMoments::deviation(double least) const {
  return variance().cwiseSqrt().cwiseMax(least);
}

Eigen::VectorXd RunningMoments::state() const {
  Eigen::VectorXd all(1 + 2 * mean_.size());
  all << count_, mean_, squares_;
  return all;
}

void RunningMoments::set_state(const Eigen::Ref<const Eigen::VectorXd>& state) {
  count_ = state(0);
  mean_ = state.segment(1, mean_.size());
  squares_ = state.tail(mean_.size());
}

}  // namespace torquewright::learning
