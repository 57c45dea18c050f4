// SPDX-License-Identifier: Apache-2.0
#include "identification/experiment/separability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::identification {
namespace {

/// Eigenvalues below this are round-off: exact identities.
constexpr double kLeastEigenvalue = 1e-10;

}  // namespace

Separability separability(const Eigen::MatrixXd& information) {
  const auto all = static_cast<std::size_t>(information.rows());
  Separability result;
  result.standard_error.assign(all, std::numeric_limits<double>::infinity());
  result.share.assign(all, 0.0);
  for (std::size_t i = 0; i < all; ++i) result.nearest.push_back(i);
  std::vector<Eigen::Index> excited;
  for (Eigen::Index i = 0; i < information.rows(); ++i) {
    if (information(i, i) > 0.0) excited.push_back(i);
  }
  if (excited.empty()) return result;
  const Eigen::MatrixXd part = information(excited, excited);
  const Eigen::VectorXd scale = part.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * part * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  result.smallest_eigenvalue = excited.size() == all ? std::max(0.0, solver.eigenvalues()[0]) : 0.0;
  const Eigen::VectorXd values = solver.eigenvalues().cwiseMax(kLeastEigenvalue);
  const Eigen::MatrixXd inverse = solver.eigenvectors() * values.cwiseInverse().asDiagonal() *
                                  solver.eigenvectors().transpose();
  for (std::size_t k = 0; k < excited.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const auto parameter = static_cast<std::size_t>(excited[k]);
    result.share[parameter] = std::min(1.0, 1.0 / inverse(row, row));
    result.standard_error[parameter] = scale[row] * std::sqrt(inverse(row, row));
    double largest = -1.0;
    for (std::size_t other = 0; other < excited.size(); ++other) {
      const auto column = static_cast<Eigen::Index>(other);
      const double correlation =
          std::abs(inverse(row, column)) / std::sqrt(inverse(row, row) * inverse(column, column));
      if (other == k || correlation <= largest) continue;
      largest = correlation;
      result.nearest[parameter] = static_cast<std::size_t>(excited[other]);
    }
  }
  return result;
}

}  // namespace torquewright::identification
