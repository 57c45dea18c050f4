// SPDX-License-Identifier: Apache-2.0
// Of a search that ends before it solved, the best point that it met. Oracle: all points that were
// evaluated, noted by the rows themselves and compared one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimization/nonlinear/search.hpp"
#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

struct Visit {
  std::vector<double> point;
  double objective;
  double violation;
};

constexpr double kRowScale = 4.0;

/// min x1 x4 (x1 + x2 + x3) + x3 on the sphere of radius sqrt(40), as HS71.
double cost_of(const std::vector<double>& x) { return x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2]; }
double violation_of(const std::vector<double>& x) {
  double square = 0.0;
  for (const double element : x) square += element * element;
  return std::abs(square / kRowScale - 40.0 / kRowScale);
}

/// `visits` gets whatever is evaluated as doubles; derivatives are jets.
Program watched_program(std::vector<Visit>& visits) {
  const auto row = [&visits]<typename N>(const std::vector<N>& x) {
    if constexpr (std::is_same_v<N, double>) visits.push_back({x, cost_of(x), violation_of(x)});
    return std::vector<N>{x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]};
  };
  Program program;
  program.add(
      {"x", {1.0, 5.0, 5.0, 1.0}, std::vector<Bounds>(4, {1.0, 5.0}), {1.0, 1.0, 1.0, 1.0}});
  program.add_cost(formula_cost(
      {0, 1, 2, 3}, [](const auto& x) { return x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2]; }));
  program.add_rows(std::make_unique<FormulaRows<decltype(row)>>(
      std::vector<int>{0, 1, 2, 3}, std::vector<Bounds>{{40.0, 40.0}},
      std::vector<double>{kRowScale}, row));
  return program;
}

/// The cheapest of those within the tolerance, else the least violating.
const Visit& best_of(const std::vector<Visit>& visits, double tolerance) {
  const Visit* cheapest = nullptr;
  const Visit* nearest = &visits.front();
  for (const Visit& visit : visits) {
    const bool is_within = visit.violation <= tolerance;
    if (is_within && (!cheapest || visit.objective < cheapest->objective)) cheapest = &visit;
    if (visit.violation < nearest->violation) nearest = &visit;
  }
  return cheapest ? *cheapest : *nearest;
}

class BestPoint : public testing::TestWithParam<double> {};

TEST_P(BestPoint, IsKeptAtALimitOfIterations) {
  int limited = 0;
  for (int most = 0; most < 12; ++most) {
    std::vector<Visit> visits;
    const Program program = watched_program(visits);
    const NonlinearSolution solution =
        solve(program, {.tolerance = GetParam(), .most_iterations = most});
    if (solution.status != NonlinearStatus::kIterationLimit) continue;
    ++limited;
    EXPECT_EQ(solution.iterations, most);
    const Visit& best = best_of(visits, GetParam());
    EXPECT_EQ(solution.values, best.point) << most;
    EXPECT_NEAR(solution.objective, best.objective, 1e-13 * best.objective);
    EXPECT_NEAR(solution.largest_violation, best.violation, 1e-13);
    EXPECT_TRUE(solution.multipliers.empty());
  }
  EXPECT_GT(limited, 3);
}

// With the wide ones, points within the tolerance are met long before the optimum.
INSTANTIATE_TEST_SUITE_P(Tolerances, BestPoint, testing::Values(1e-7, 1e-3, 0.03));

Evaluation evaluation(double objective, double violation) {
  return {{0.0}, objective, {}, violation, true};
}

// Oracle: the order as search.hpp states it; every pair in both orders.
TEST(IsBetter, RanksByOneKey) {
  constexpr double kWithin = 0.1;
  const std::vector<Evaluation> from_best = {evaluation(-5.0, 0.1), evaluation(1.0, 0.0),
                                             evaluation(2.0, 0.05), evaluation(7.0, 0.2),
                                             evaluation(-9.0, 0.3)};
  for (std::size_t i = 0; i < from_best.size(); ++i) {
    for (std::size_t j = 0; j < from_best.size(); ++j) {
      const Candidate held = {{0.0}, from_best[j].objective, from_best[j].largest_violation};
      EXPECT_EQ(is_better(from_best[i], held, kWithin), i < j) << i << " " << j;
    }
  }
  EXPECT_TRUE(is_better(from_best.back(), {}, kWithin));
  Evaluation broken = from_best.front();
  broken.is_finite = false;
  EXPECT_FALSE(is_better(broken, {}, kWithin));
}

}  // namespace
}  // namespace torquewright::optimization
