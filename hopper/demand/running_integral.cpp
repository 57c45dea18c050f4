// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/running_integral.hpp"

#include <algorithm>

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::VectorXd;

RunningIntegral::RunningIntegral(const std::vector<double>& times_s, const Eigen::MatrixXd& signals)
    : times_s_(times_s),
      signals_(signals),
      before_(Eigen::MatrixXd::Zero(signals.rows(), signals.cols())),
      impulse_(Eigen::MatrixXd::Zero(signals.rows(), signals.cols())) {
  for (Index i = 1; i < signals.cols(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    before_.col(i) = before_.col(i - 1) +
                     0.5 * (times_s[k] - times_s[k - 1]) * (signals.col(i - 1) + signals.col(i));
  }
}

void RunningIntegral::add_impulse(Index sample, const VectorXd& impulse) {
  impulse_.col(sample) += impulse;
  before_.rightCols(before_.cols() - sample - 1).colwise() += impulse;
}

VectorXd RunningIntegral::over(Index from_sample, double duration_s) const {
  return until(times_s_[static_cast<std::size_t>(from_sample)] + duration_s) -
         before_.col(from_sample);
}

VectorXd RunningIntegral::until(double time_s) const {
  const auto above = std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
  const auto sample = static_cast<Index>(above - times_s_.begin()) - 1;
  VectorXd sum = before_.col(sample) + impulse_.col(sample);
  if (above == times_s_.end()) return sum;
  const double step_s = *above - *(above - 1);
  const double inside_s = time_s - *(above - 1);
  const VectorXd slope = (signals_.col(sample + 1) - signals_.col(sample)) / step_s;
  return sum + inside_s * signals_.col(sample) + 0.5 * inside_s * inside_s * slope;
}

}  // namespace torquewright::hopper
