// SPDX-License-Identifier: Apache-2.0
// What a small change of a program costs. Oracle: least objectives in closed form, differentiated
// by hand.
#include "optimization/nonlinear/first_order.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

// The solver's 1e-7 of scaled slopes; what is asked of it is near 1.
constexpr double kOfSolver = 1e-5;
constexpr double kMove = 1e-3;

/// min cost (x^2 + y^2), slope (x + y) >= least, x in its bounds.
struct Numbers {
  double cost = 1.0;
  double slope = 1.0;
  double least = 2.0;
  Bounds x = {};
};

Program program_of(const Numbers& of) {
  Program program;
  program.add({"x", {3.0, 2.0}, {of.x, {}}, {2.0, 0.5}});
  const double cost = of.cost, slope = of.slope;
  program.add_cost(
      formula_cost({0, 1}, [cost](const auto& x) { return cost * (x[0] * x[0] + x[1] * x[1]); }));
  program.add_rows(
      formula_rows({0, 1}, {{of.least, HUGE_VAL}}, [slope]<typename N>(const std::vector<N>& x) {
        return std::vector<N>{slope * (x[0] + x[1])};
      }));
  return program;
}

double change(const Numbers& from, const Numbers& to) {
  const Program program = program_of(from);
  const auto found = first_order_change(program, solve(program, {}), program_of(to));
  return found.value_or(std::nan(""));
}

// least^2 cost / (2 slope^2), where x is free.
TEST(FirstOrderChange, IsTheSlopeOfTheLeastObjective) {
  EXPECT_NEAR(change({}, {.least = 2.0 + kMove}), 2.0 * kMove, kOfSolver * kMove);
  EXPECT_NEAR(change({}, {.cost = 1.0 + kMove}), 2.0 * kMove, kOfSolver * kMove);
  // By the slope itself -4; the row's change at the solution is its step times 2.
  EXPECT_NEAR(change({}, {.slope = 1.0 + kMove}), -4.0 * kMove, kOfSolver * kMove);
}

// x at its bound b, y = least - b: b^2 + (least - b)^2.
TEST(FirstOrderChange, KnowsBoundsOfUnknowns) {
  EXPECT_NEAR(change({.x = {1.5, HUGE_VAL}}, {.x = {1.5 + kMove, HUGE_VAL}}), 2.0 * kMove,
              kOfSolver * kMove);
  EXPECT_NEAR(change({.x = {-HUGE_VAL, 0.5}}, {.x = {-HUGE_VAL, 0.5 + kMove}}), -2.0 * kMove,
              kOfSolver * kMove);
  // One that does not hold it costs nothing.
  EXPECT_NEAR(change({.x = {-5.0, 5.0}}, {.x = {-4.0, 4.0}}), 0.0, kOfSolver);
}

TEST(FirstOrderChange, IsNoneOfAnotherProgram) {
  const Program program = program_of({});
  Program longer = program_of({});
  longer.add({"y", {0.0}, {{}}, {1.0}});
  EXPECT_FALSE(first_order_change(program, solve(program, {}), longer));
  Program more_rows = program_of({});
  more_rows.add_rows(formula_rows(
      {0}, {{0.0, 9.0}}, []<typename N>(const std::vector<N>& x) { return std::vector<N>{x[0]}; }));
  EXPECT_FALSE(first_order_change(program, solve(program, {}), more_rows));
  EXPECT_FALSE(first_order_change(program, NonlinearSolution(), program_of({})));
}

}  // namespace
}  // namespace torquewright::optimization
