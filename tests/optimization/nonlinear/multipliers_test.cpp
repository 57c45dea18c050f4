// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

template <typename Formula>
std::unique_ptr<const Rows> scaled_rows(std::vector<Bounds> bounds, std::vector<double> scales,
                                        Formula formula) {
  return std::make_unique<FormulaRows<Formula>>(std::vector<int>{0, 1}, std::move(bounds),
                                                std::move(scales), formula);
}

constexpr auto kSum = []<typename N>(const std::vector<N>& x) {
  return std::vector<N>{x[0] + x[1]};
};
constexpr auto kSquares = []<typename N>(const std::vector<N>& x) {
  return std::vector<N>{x[0] * x[0] + x[1] * x[1]};
};

/// min x^2 + y^2 on scales of its own, its sum between bounds.
NonlinearSolution least_squares_between(const Bounds& bounds) {
  Program program;
  program.add({"x", {3.0, -1.0}, {{}, {}}, {10.0, 0.1}});
  program.add_cost(scaled_rows({{}}, {7.0}, kSquares));
  program.add_rows(scaled_rows({bounds}, {4.0}, kSum));
  return solve(program, {});
}

// Oracle: x = y = b/2 and f(b) = b^2/2, so that df/db = b, whichever bound it is; the multiplier is
// -df/db. Between them it is 0.
TEST(Multipliers, AreMinusTheSlopeOfTheOptimumByTheBound) {
  // 1e-7 of scaled slopes: times 7 over 0.1.
  constexpr double kError = 1e-5;
  EXPECT_NEAR(least_squares_between({2.0, HUGE_VAL}).multipliers.at(0), -2.0, kError);
  EXPECT_NEAR(least_squares_between({-HUGE_VAL, -3.0}).multipliers.at(0), 3.0, kError);
  EXPECT_NEAR(least_squares_between({5.0, 5.0}).multipliers.at(0), -5.0, kError);
  EXPECT_NEAR(least_squares_between({-1.0, 1.0}).multipliers.at(0), 0.0, kError);
  for (const double bound : {2.0, 2.5}) {
    EXPECT_NEAR(least_squares_between({bound, HUGE_VAL}).objective, bound * bound / 2.0, kError);
  }
}

// As many equations as unknowns leave nothing to choose, but bounds have their prices: x^2 + y^2 =
// 25 and x y = 12 have (4, 3); J' lambda = -(1, 2) there. Oracle: Cramer's rule.
TEST(Multipliers, OfAsManyEquationsAsUnknowns) {
  Program program;
  program.add({"x", {5.0, 2.0}, {{}, {}}, {2.0, 0.5}});
  program.add_cost(formula_cost({0, 1}, [](const auto& x) { return x[0] + 2.0 * x[1]; }));
  program.add_rows(scaled_rows({{25.0, 25.0}, {12.0, 12.0}}, {3.0, 0.7},
                               []<typename N>(const std::vector<N>& x) {
                                 return std::vector<N>{x[0] * x[0] + x[1] * x[1], x[0] * x[1]};
                               }));
  const NonlinearSolution solution = solve(program, {});
  ASSERT_EQ(solution.status, NonlinearStatus::kSolved);
  EXPECT_NEAR(solution.values.at(0), 4.0, 1e-6);
  EXPECT_NEAR(solution.values.at(1), 3.0, 1e-6);
  // 8 a + 3 b = -1, 6 a + 4 b = -2.
  EXPECT_NEAR(solution.multipliers.at(0), (-1.0 * 4.0 + 2.0 * 3.0) / (8.0 * 4.0 - 3.0 * 6.0), 1e-6);
  EXPECT_NEAR(solution.multipliers.at(1), (-2.0 * 8.0 + 1.0 * 6.0) / (8.0 * 4.0 - 3.0 * 6.0), 1e-6);
}

TEST(Multipliers, AreNoneWhereNothingWasSolved) {
  Program program;
  program.add({"x", {3.0, 0.0}, {{}, {}}, {1.0, 1.0}});
  program.add_rows(scaled_rows({{-HUGE_VAL, -1.0}}, {1.0}, kSquares));
  EXPECT_TRUE(solve(program, {}).multipliers.empty());
}

// Nothing is free: one multiplier a row all the same.
TEST(Multipliers, AreZeroWhereEveryUnknownIsFixed) {
  Program program;
  program.add({"x", {1.0, 1.0}, {{1.0, 1.0}, {1.0, 1.0}}, {1.0, 1.0}});
  program.add_rows(scaled_rows({{0.0, 2.0}}, {1.0}, kSum));
  const NonlinearSolution solution = solve(program, {});
  EXPECT_EQ(solution.status, NonlinearStatus::kSolved);
  EXPECT_EQ(solution.multipliers, std::vector<double>{0.0});
}

}  // namespace
}  // namespace torquewright::optimization
