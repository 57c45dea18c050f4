// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optimization/quadratic/program.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::optimization {

inline double cost_of(const QuadraticProgram& program, const Eigen::VectorXd& x) {
  return 0.5 * x.dot(program.cost * x) + program.slope.dot(x);
}

/// The conditions of Karush, Kuhn and Tucker, which are enough for an optimum where the cost is
/// convex: written down here once more, over the size of what they sum. Round-off of some hundred
/// sums is 1e-13; `error` allows for the condition of the numbers drawn.
inline void expect_optimal(const QuadraticProgram& program, const QuadraticSolution& solution,
                           double error) {
  ASSERT_EQ(solution.status, QuadraticStatus::kSolved) << name_of(solution.status);
  const Eigen::VectorXd& x = solution.x;
  const Eigen::VectorXd& m = solution.multipliers;
  ASSERT_TRUE(x.allFinite() && m.allFinite());
  ASSERT_EQ(m.size(), program.rows.rows());
  const double size = 1.0 + program.slope.norm() + (program.cost * x).norm();
  Eigen::VectorXd gradient = program.cost * x + program.slope;
  if (m.size() > 0) gradient += program.rows.transpose() * m;
  EXPECT_LE(gradient.norm(), error * size);
  for (Eigen::Index row = 0; row < m.size(); ++row) {
    const double value = program.rows.row(row).dot(x);
    const double room = error * (1.0 + program.rows.row(row).norm() * x.norm());
    EXPECT_GE(value, program.lower[row] - room) << row;
    EXPECT_LE(value, program.upper[row] + room) << row;
    if (program.lower[row] == program.upper[row] || m[row] == 0.0) continue;
    // Multipliers pull from their own bound alone, and only where it is met.
    EXPECT_NEAR(value, m[row] > 0.0 ? program.upper[row] : program.lower[row], room) << row;
  }
}

}  // namespace torquewright::optimization
