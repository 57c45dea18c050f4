// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/errors.hpp"

#include <cmath>

namespace torquewright::identification {

Errors errors_over(const ForwardEquation& equation, const Rows& rows,
                   const Eigen::VectorXd& residual) {
  double square[2] = {0.0, 0.0}, count[2] = {0.0, 0.0};
  for (const Rows::Block& block : rows.blocks()) {
    square[block.is_held_out()] += residual.segment(block.begin, block.count).squaredNorm();
    count[block.is_held_out()] += static_cast<double>(block.count);
  }
  const auto rms = [&](int k) {
    return count[k] > 0.0 ? std::sqrt(square[k] / count[k]) * std::abs(equation.unit_per_residual)
                          : 0.0;
  };
  return {rms(0), rms(1)};
}

}  // namespace torquewright::identification
