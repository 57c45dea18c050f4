// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/row_comparison.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

const double kDecides = std::log(1000.0);
constexpr double kRounding = 1e-24;  // of the squares of what the readings differ by

}  // namespace

bool RowEvidence::is_own() const { return log_odds < -kDecides; }

bool RowEvidence::is_before() const { return log_odds > kDecides; }

const VectorXd& RowComparison::at(const Left& left, int row) {
  return left[static_cast<std::size_t>(row - kFirst)];
}

void RowComparison::allocate(Index size) {
  squares_.assign(own_.size() + before_.size(), VectorXd::Zero(size));
  second_.setZero(size);
  fourth_.setZero(size);
}

void RowComparison::add(const Left& left) {
  const VectorXd change = at(left, 1) - at(left, 0);
  if (squares_.empty()) allocate(change.size());
  second_ += change.cwiseAbs2();
  fourth_ += change.cwiseAbs2().cwiseAbs2();
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    const RowSpan& span = i < own_.size() ? own_[i] : before_[i - own_.size()];
    squares_[i] += (0.5 * (at(left, span.first) + at(left, span.last))).cwiseAbs2();
  }
}

RowEvidence RowComparison::evidence() const {
  RowEvidence found;
  if (squares_.empty()) return found;
  const Index size = second_.size();
  VectorXd counts = VectorXd::Zero(size);
  for (Index i = 0; i < size; ++i) {
    if (fourth_[i] > 0.0) counts[i] = second_[i] * second_[i] / fourth_[i];
  }
  found.differs = !counts.isZero(0.0);
  if (!found.differs) return found;
  const auto likelihood = [&](std::size_t span) {
    double sum = 0.0;
    for (Index i = 0; i < size; ++i) {
      if (counts[i] == 0.0) continue;
      sum -= 0.5 * counts[i] * std::log(squares_[span][i] + kRounding * second_[i]);
    }
    return sum;
  };
  const auto best = [&](std::size_t from, std::size_t to) {
    double most = likelihood(from);
    for (std::size_t i = from + 1; i < to; ++i) most = std::max(most, likelihood(i));
    return most;
  };
  found.log_odds = best(own_.size(), squares_.size()) - best(0, own_.size());
  found.times_less = std::exp(found.log_odds / counts.sum());
  return found;
}

}  // namespace torquewright::hopper
