// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

// min (x - 3)^2 + (y - 2)^2 with x + y <= 1. Oracle: the foot of the perpendicular, (1, 0); the
// gradient (-4, -4) is balanced by 4 times the row's.
TEST(NonlinearStatus, SolvedAtTheFootOfAPerpendicular) {
  Program program;
  program.add({"x", {0.0, 0.0}, {{}, {}}, {1.0, 1.0}});
  program.add_cost(formula_cost({0, 1}, [](const auto& x) {
    return (x[0] - 3.0) * (x[0] - 3.0) + (x[1] - 2.0) * (x[1] - 2.0);
  }));
  program.add_rows(formula_rows(
      {0, 1}, {{-HUGE_VAL, 1.0}},
      []<typename N>(const std::vector<N>& x) { return std::vector<N>{x[0] + x[1]}; }));
  const NonlinearSolution solution = solve(program, {});
  EXPECT_EQ(solution.status, NonlinearStatus::kSolved);
  EXPECT_NEAR(solution.values.at(0), 1.0, 1e-6);
  EXPECT_NEAR(solution.values.at(1), 0.0, 1e-6);
  EXPECT_NEAR(solution.multipliers.at(0), 4.0, 1e-6);
}

}  // namespace
}  // namespace torquewright::optimization
