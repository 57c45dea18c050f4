// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace torquewright::actuator {

/// A 2 x 2 matrix, row by row: {a, b, c, d} is [a b; c d].
using Matrix2 = std::array<double, 4>;

/// Two actuators that move two joints together, as a parallel ankle does. With J the matrix at the
/// joints' angles, actuator speeds are w_a = J w_j, and so, no power being lost between them, joint
/// torques are tau_j = J^T tau_a. docs/derivations/check.md eq. (2).
struct ParallelDrive {
  std::string name;
  std::array<std::string, 2> joints;
  std::array<std::string, 2> actuators;

  /// Angles of the grid, ascending. One matrix without angles: it is constant.
  std::vector<double> first_rad;
  std::vector<double> second_rad;
  std::vector<Matrix2> matrices;  ///< Matrices of the grid; the second angle runs faster.

  bool is_constant() const { return first_rad.empty(); }
};

/// Interpolates the matrix at the joints' angles (bilinear). Empty outside of the grid.
std::optional<Matrix2> jacobian_at(const ParallelDrive& drive, double first_rad, double second_rad);

/// Returns actuator speeds J w.
std::array<double, 2> actuator_speeds(const Matrix2& jacobian, const std::array<double, 2>& joints);

/// Returns the tau_a with J^T tau_a = tau_j. Empty where J is singular (to kSingular of its size).
std::optional<std::array<double, 2>> actuator_torques(const Matrix2& jacobian,
                                                      const std::array<double, 2>& joints);
constexpr double kSingular = 1e-6;

}  // namespace torquewright::actuator
