// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/wave_pursuit.hpp"

#include <Eigen/LU>

namespace torquewright::identification {
namespace {

/// Of a column's power, or the square of a pair's, that has to be left beside the others.
constexpr double kDependent = 1e-6;

/// Takes columns' shares out of all products: what is left of each beside them.
void project_out(Eigen::MatrixXd& products, Eigen::Index first, Eigen::Index count) {
  const Eigen::MatrixXd inverse = products.block(first, first, count, count).inverse();
  const Eigen::MatrixXd columns = products.middleCols(first, count);
  products -= columns * inverse * columns.transpose();
}

}  // namespace

WavePursuit::WavePursuit(Eigen::Index beside, std::size_t waves) : beside_(beside), waves_(waves) {
  const Eigen::Index size = 1 + beside + 2 * static_cast<Eigen::Index>(waves);
  products_ = Eigen::MatrixXd::Zero(size, size);
}

void WavePursuit::add(const Eigen::VectorXd& row) {
  products_.selfadjointView<Eigen::Lower>().rankUpdate(row);
}

std::vector<std::size_t> WavePursuit::strongest(std::size_t most, double least_share) const {
  Eigen::MatrixXd left = products_.selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd power = left.diagonal();
  for (Eigen::Index c = 1; c <= beside_; ++c) {
    if (left(c, c) > kDependent * power[c]) project_out(left, c, 1);
  }
  const double of_columns = left(0, 0);
  std::vector<std::size_t> found;
  while (found.size() < most) {
    double best_share = least_share;
    std::size_t best = waves_;
    for (std::size_t w = 0; w < waves_; ++w) {
      const Eigen::Index c = 1 + beside_ + 2 * static_cast<Eigen::Index>(w);
      const Eigen::Matrix2d own = left.block<2, 2>(c, c);
      if (!(own.determinant() > kDependent * power[c] * power[c + 1])) continue;
      const Eigen::Vector2d with_target = left.block<2, 1>(c, 0);
      const double share = with_target.dot(own.inverse() * with_target) / of_columns;
      if (share <= best_share) continue;
      best_share = share;
      best = w;
    }
    if (best == waves_) break;
    project_out(left, 1 + beside_ + 2 * static_cast<Eigen::Index>(best), 2);
    found.push_back(best);
  }
  return found;
}

}  // namespace torquewright::identification
