// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/parabola.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

constexpr double kHalfOfParabola_s = 0.06;

}  // namespace

Motion parabola(const std::vector<double>& time_s, const std::vector<double>& values,
                std::size_t at, std::size_t half) {
  Eigen::Matrix3d power = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = at - half; i <= at + half; ++i) {
    const double t = time_s[i] - time_s[at];
    const Eigen::Vector3d row(1.0, t, 0.5 * t * t);
    power += row * row.transpose();
    right += row * values[i];
  }
  const Eigen::Vector3d found = power.ldlt().solve(right);
  return {found[0], found[1], found[2]};
}

std::size_t half_of_parabola(const std::vector<double>& time_s) {
  const double step_s = (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
  const double half = std::round(kHalfOfParabola_s / step_s);
  return static_cast<std::size_t>(std::max(2.0, half));
}

}  // namespace torquewright::identification
