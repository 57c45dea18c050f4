// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/jacobian.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

/// The interval of an ascending grid that holds the value, and how far in it lies (0...1).
struct GridPlace {
  std::size_t index;
  double share;
};

std::optional<GridPlace> place_in(const std::vector<double>& grid, double value) {
  if (!(value >= grid.front() && value <= grid.back())) return std::nullopt;
  const auto above = std::upper_bound(grid.begin() + 1, grid.end() - 1, value);
  const auto index = static_cast<std::size_t>(above - grid.begin()) - 1;
  return GridPlace{index, (value - grid[index]) / (grid[index + 1] - grid[index])};
}

Matrix2 between(const Matrix2& one, const Matrix2& other, double share) {
  Matrix2 result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = one[i] + share * (other[i] - one[i]);
  return result;
}

}  // namespace

std::optional<Matrix2> jacobian_at(const ParallelDrive& drive, double first_rad,
                                   double second_rad) {
  if (drive.is_constant()) return drive.matrices.front();
  const std::optional<GridPlace> first = place_in(drive.first_rad, first_rad);
  const std::optional<GridPlace> second = place_in(drive.second_rad, second_rad);
  if (!first || !second) return std::nullopt;
  const auto along_second = [&](std::size_t row) {
    const std::size_t start = row * drive.second_rad.size() + second->index;
    return between(drive.matrices[start], drive.matrices[start + 1], second->share);
  };
  return between(along_second(first->index), along_second(first->index + 1), first->share);
}

std::array<double, 2> actuator_speeds(const Matrix2& jacobian,
                                      const std::array<double, 2>& joints) {
  const auto& [a, b, c, d] = jacobian;
  return {a * joints[0] + b * joints[1], c * joints[0] + d * joints[1]};
}

std::optional<std::array<double, 2>> actuator_torques(const Matrix2& jacobian,
                                                      const std::array<double, 2>& joints) {
  const auto& [a, b, c, d] = jacobian;
  const double determinant = a * d - b * c;
  const double square = a * a + b * b + c * c + d * d;
  if (!(std::abs(determinant) > kSingular * square)) return std::nullopt;
  // The transpose is [a c; b d].
  return std::array<double, 2>{(d * joints[0] - c * joints[1]) / determinant,
                               (a * joints[1] - b * joints[0]) / determinant};
}

}  // namespace torquewright::actuator
