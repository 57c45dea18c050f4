// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "optimization/quadratic/solver.hpp"
#include "tests/dynamics/allocation_count.hpp"
#include "tests/optimization/quadratic/first_order.hpp"

namespace torquewright::optimization {
namespace {

using Eigen::Index;

/// As a biped's whole body asks in each millisecond: 48 unknowns, 34 equations of which some depend
/// on others, 40 bounds.
QuadraticProgram biped_sized(oracles::Dice& dice) {
  constexpr Index kUnknowns = 48, kEquations = 34, kBounds = 40;
  QuadraticProgram program;
  Eigen::MatrixXd root(40, kUnknowns);
  program.rows.resize(kEquations + kBounds, kUnknowns);
  for (Index i = 0; i < root.size(); ++i) root.data()[i] = test::uniform(dice, -1, 1);
  for (Index i = 0; i < program.rows.size(); ++i)
    program.rows.data()[i] = test::uniform(dice, -1, 1);
  program.rows.row(3) = program.rows.row(1) - program.rows.row(2);
  program.cost = root.transpose() * root + 1e-4 * Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
  program.slope = 10.0 * root.transpose() * Eigen::VectorXd::Ones(40);
  program.lower.setZero(kEquations + kBounds);
  program.upper.setZero(kEquations + kBounds);
  program.lower.tail(kBounds).setConstant(-1.0);
  program.upper.tail(kBounds).setConstant(2.0);
  return program;
}

TEST(QuadraticSolver, TakesNoMemoryOnceItHasSolvedOneOfTheSize) {
  oracles::Dice dice(7);
  QuadraticSolver solver;
  (void)solver.solve(biped_sized(dice));
  for (int sample = 0; sample < 20; ++sample) {
    const QuadraticProgram program = biped_sized(dice);
    const long before = test::allocation_count();
    const QuadraticSolution& solution = solver.solve(program);
    EXPECT_EQ(test::allocation_count(), before);
    expect_optimal(program, solution, 1e-8);
    EXPECT_GT(solution.steps, 0);
  }
}

}  // namespace
}  // namespace torquewright::optimization
