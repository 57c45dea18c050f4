// SPDX-License-Identifier: Apache-2.0
// Small problems of Maros and Meszaros' set of quadratic programs, as W. Hock and K. Schittkowski
// (Test Examples for Nonlinear Programming Codes, Springer 1981) state them, and their optima.
#include <gtest/gtest.h>

#include <limits>

#include "optimization/quadratic/solver.hpp"
#include "tests/optimization/quadratic/first_order.hpp"

namespace torquewright::optimization {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOpen = std::numeric_limits<double>::infinity();

/// Of so many unknowns without rows, to which they are added.
QuadraticProgram empty(Index n) {
  return {MatrixXd::Zero(n, n), VectorXd::Zero(n), MatrixXd(0, n), VectorXd(0), VectorXd(0)};
}

void add(QuadraticProgram& program, double lower, std::vector<double> row, double upper) {
  const Index at = program.rows.rows();
  program.rows.conservativeResize(at + 1, Eigen::NoChange);
  program.lower.conservativeResize(at + 1);
  program.upper.conservativeResize(at + 1);
  program.rows.row(at) =
      Eigen::Map<const Eigen::RowVectorXd>(row.data(), static_cast<Index>(row.size()));
  program.lower[at] = lower;
  program.upper[at] = upper;
}

void bound(QuadraticProgram& program, Index unknown, double lower, double upper) {
  std::vector<double> row(static_cast<std::size_t>(program.slope.size()), 0.0);
  row[static_cast<std::size_t>(unknown)] = 1.0;
  add(program, lower, row, upper);
}

/// Adds (row x - target)^2, but for its constant.
void add_square(QuadraticProgram& program, std::vector<double> row, double target) {
  const Eigen::Map<const VectorXd> r(row.data(), static_cast<Index>(row.size()));
  program.cost += 2.0 * r * r.transpose();
  program.slope -= 2.0 * target * r;
}

void expect_optimum(const char* name, const QuadraticProgram& program, double constant,
                    double published, double printed) {
  SCOPED_TRACE(name);
  QuadraticSolver solver;
  const QuadraticSolution& found = solver.solve(program);
  expect_optimal(program, found, 1e-9);
  EXPECT_NEAR(cost_of(program, found.x) + constant, published, printed);
}

TEST(PublishedQuadraticPrograms, HS21) {
  QuadraticProgram program = empty(2);
  program.cost.diagonal() << 0.02, 2.0;
  add(program, 10.0, {10, -1}, kOpen);
  bound(program, 0, 2.0, 50.0);
  bound(program, 1, -50.0, 50.0);
  expect_optimum("HS21", program, -100.0, -99.96, 1e-9);
}

TEST(PublishedQuadraticPrograms, HS35) {
  QuadraticProgram program = empty(3);
  program.cost << 4, 2, 2, 2, 4, 0, 2, 0, 2;
  program.slope << -8, -6, -4;
  add(program, -kOpen, {1, 1, 2}, 3.0);
  for (Index i = 0; i < 3; ++i) bound(program, i, 0.0, kOpen);
  expect_optimum("HS35", program, 9.0, 1.0 / 9.0, 1e-9);
}

/// HS51 to HS53: equations that leave two of five free, where the cost has rank 4.
QuadraticProgram with_equations(double first, double sum) {
  QuadraticProgram program = empty(5);
  add_square(program, {first, -1, 0, 0, 0}, 0.0);
  add_square(program, {0, 1, 1, 0, 0}, 2.0);
  add_square(program, {0, 0, 0, 1, 0}, 1.0);
  add_square(program, {0, 0, 0, 0, 1}, 1.0);
  add(program, sum, {1, 3, 0, 0, 0}, sum);
  add(program, 0.0, {0, 0, 1, 1, -2}, 0.0);
  add(program, 0.0, {0, 1, 0, 0, -1}, 0.0);
  return program;
}

TEST(PublishedQuadraticPrograms, HS51to53) {
  constexpr double kTargets = 6.0;  // 2^2 + 1 + 1
  expect_optimum("HS51", with_equations(1.0, 4.0), kTargets, 0.0, 1e-9);
  expect_optimum("HS52", with_equations(4.0, 0.0), kTargets, 1859.0 / 349.0, 1e-9);
  QuadraticProgram program = with_equations(1.0, 0.0);
  for (Index i = 0; i < 5; ++i) bound(program, i, -10.0, 10.0);
  expect_optimum("HS53", program, kTargets, 176.0 / 43.0, 1e-9);
}

TEST(PublishedQuadraticPrograms, HS76) {
  QuadraticProgram program = empty(4);
  program.cost << 2, 0, -1, 0, 0, 1, 0, 0, -1, 0, 2, 1, 0, 0, 1, 1;
  program.slope << -1, -3, 1, -1;
  add(program, -kOpen, {1, 2, 1, 1}, 5.0);
  add(program, -kOpen, {3, 1, 2, -1}, 4.0);
  add(program, 1.5, {0, 1, 4, 0}, kOpen);
  for (Index i = 0; i < 4; ++i) bound(program, i, 0.0, kOpen);
  expect_optimum("HS76", program, 0.0, -4.681818181, 1e-9);
}

TEST(PublishedQuadraticPrograms, HS118) {
  constexpr double kSlopes[] = {2.3, 1.7, 2.2}, kCurves[] = {0.0001, 0.0001, 0.00015};
  constexpr double kSteps[] = {6.0, 7.0, 6.0}, kMost[] = {90.0, 120.0, 60.0};
  constexpr double kSums[] = {60, 50, 70, 85, 100};
  constexpr double kFirst[3][2] = {{8, 21}, {43, 57}, {3, 16}};
  QuadraticProgram program = empty(15);
  for (Index i = 0; i < 15; ++i) {
    program.slope[i] = kSlopes[i % 3];
    program.cost(i, i) = 2.0 * kCurves[i % 3];
    bound(program, i, i < 3 ? kFirst[i][0] : 0.0, i < 3 ? kFirst[i][1] : kMost[i % 3]);
    std::vector<double> row(15, 0.0);
    if (i % 3 == 0) {
      for (Index k = i; k < i + 3; ++k) row[static_cast<std::size_t>(k)] = 1.0;
      add(program, kSums[i / 3], row, kOpen);
      row.assign(15, 0.0);
    }
    if (i < 3) continue;
    row[static_cast<std::size_t>(i)] = 1.0;
    row[static_cast<std::size_t>(i) - 3] = -1.0;
    add(program, -7.0, row, kSteps[i % 3]);
  }
  expect_optimum("HS118", program, 0.0, 664.8204500, 1e-7);
}

}  // namespace
}  // namespace torquewright::optimization
