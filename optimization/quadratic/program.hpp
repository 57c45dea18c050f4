// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace torquewright::optimization {

/// A convex quadratic program: minimise x^T cost x / 2 + slope^T x so that lower <= rows x <=
/// upper. Dense. Bounds of an unknown are rows as any other.
struct QuadraticProgram {
  Eigen::MatrixXd cost;   ///< (n x n), symmetric, without negative curvature.
  Eigen::VectorXd slope;  ///< (n x 1)
  Eigen::MatrixXd rows;   ///< (m x n)
  /// (m x 1) each, infinite where there is no bound. Equal ones make an equation; equations may
  /// depend on each other.
  Eigen::VectorXd lower, upper;
};

/// How a solve ended.
enum class QuadraticStatus {
  kSolved,
  kInfeasible,  ///< No point obeys the rows that are named.
  /// The cost falls for ever along the direction. Curvature below 1e-11 of the greatest counts as
  /// none.
  kUnbounded,
  kNotConvex,  ///< The cost has a negative curvature where the equations leave room.
  kStalled,    ///< Rounding kept it from an end; the numbers are badly scaled.
};
std::string_view name_of(QuadraticStatus status);

/// What was found. Unless it is solved, x and multipliers are those of the last step.
struct QuadraticSolution {
  QuadraticStatus status = QuadraticStatus::kStalled;
  Eigen::VectorXd x;
  /// (m x 1): cost x + slope + rows^T multipliers = 0. Above 0 where an upper bound holds, below 0
  /// where a lower one does, 0 where none does; of an equation either.
  Eigen::VectorXd multipliers;
  /// kInfeasible: indices, ascending, of rows that no point obeys together; without any one of them
  /// the others have a point.
  std::vector<Eigen::Index> contradicting;
  Eigen::VectorXd direction;  ///< kUnbounded: (n x 1), of length 1.
  int steps = 0;              ///< How often a bound became active or ceased to be.
};

}  // namespace torquewright::optimization
