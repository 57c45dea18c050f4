// SPDX-License-Identifier: Apache-2.0
// Oracle: the optima that Hock and Schittkowski publish; first-order conditions, which are computed
// here from the problems' own derivatives; of those, differences of values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const double kTolerance = NonlinearOptions().tolerance;
// Points are printed with seven digits; HS80's and HS81's are off by one in the last.
constexpr double kPrintedPoint = 1.5e-6;

VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

VectorXd values_of(const Rows& rows, const VectorXd& x) {
  VectorXd out(rows.size());
  rows.values(x, out);
  return out;
}

MatrixXd slopes_of(const Rows& rows, const VectorXd& x) {
  MatrixXd out(rows.size(), rows.width());
  rows.slopes(x, out);
  return out;
}

double size_of(double number) { return std::max(1.0, std::abs(number)); }

class HockSchittkowski : public testing::TestWithParam<PublishedProblem> {
 protected:
  /// What rounding of a printed point can do to each row, to first order.
  static VectorXd rounding_of(const Rows& rows, const VectorXd& x) {
    return kPrintedPoint * slopes_of(rows, x).cwiseAbs() * x.cwiseAbs() +
           VectorXd::Constant(rows.size(), 1e-12);
  }

  /// Of a point whose first-order conditions hold to the tolerance, by how much its objective may
  /// differ from the optimum's: complementarity of each inequality, and violated rows times their
  /// multipliers.
  double allowed_gap(const NonlinearSolution& solution) const {
    double gap = 0.0;
    for (const Bounds& bounds : GetParam().bounds) gap += kTolerance * inequalities_of(bounds);
    if (!GetParam().rows) return gap;
    for (const Bounds& bounds : GetParam().rows->bounds()) {
      gap += kTolerance * inequalities_of(bounds);
    }
    for (const double multiplier : solution.multipliers) gap += kTolerance * std::abs(multiplier);
    return gap;
  }

 private:
  static int inequalities_of(const Bounds& bounds) {
    return std::isfinite(bounds.lower) + std::isfinite(bounds.upper);
  }
};

/// Whether slopes lead only out of the bounds, where they are not 0; over the tolerance times
/// `size`. Complementarity: a slope times the way to the bound that holds it is 0 too.
void expect_held(double slope, double value, const Bounds& bounds, double size) {
  const double room = slope > 0.0 ? value - bounds.lower : bounds.upper - value;
  const double excess = std::min(std::abs(slope), std::abs(slope) * std::max(0.0, room));
  EXPECT_LE(excess, 2.0 * kTolerance * size) << slope << " at " << value;
}

/// As solve.hpp states them.
void expect_first_order_conditions(const PublishedProblem& problem,
                                   const NonlinearSolution& solution,
                                   const OtherScales& scales = {}) {
  const VectorXd x = vector_of(solution.values);
  const VectorXd multipliers = vector_of(solution.multipliers);
  // Ipopt measures against the mean multiplier, of bounds too, where that is above 100.
  VectorXd slopes = slopes_of(*problem.cost, x).transpose();
  if (problem.rows) slopes += slopes_of(*problem.rows, x).transpose() * multipliers;
  const double size = std::max(1.0, (multipliers.lpNorm<1>() + slopes.lpNorm<1>()) / 100.0) *
                      scales.of_cost * std::max(scales.of_variables, scales.of_rows);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Bounds& bounds = problem.bounds[static_cast<std::size_t>(i)];
    EXPECT_LE(bounds.lower, x(i));
    EXPECT_GE(bounds.upper, x(i));
    expect_held(slopes(i), x(i), bounds, size);
  }
  if (!problem.rows) return;
  const VectorXd rows = values_of(*problem.rows, x);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const Bounds& bounds = problem.rows->bounds()[static_cast<std::size_t>(i)];
    EXPECT_LE(bounds.lower - rows(i), kTolerance * scales.of_rows);
    EXPECT_LE(rows(i) - bounds.upper, kTolerance * scales.of_rows);
    if (bounds.lower == bounds.upper) continue;
    // A multiplier above 0 says that the upper bound holds the row, so that it is a slope downward.
    expect_held(-multipliers(i), rows(i), bounds, size);
  }
}

TEST_P(HockSchittkowski, IsStatedAsPublished) {
  const PublishedProblem& problem = GetParam();
  const VectorXd x = vector_of(problem.minimiser);
  EXPECT_NEAR(values_of(*problem.cost, x)(0), problem.optimum,
              rounding_of(*problem.cost, x)(0) + problem.printed * size_of(problem.optimum));
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    EXPECT_LE(problem.bounds[static_cast<std::size_t>(i)].lower, x(i));
    EXPECT_GE(problem.bounds[static_cast<std::size_t>(i)].upper, x(i));
  }
  if (!problem.rows) return;
  const VectorXd rows = values_of(*problem.rows, x);
  const VectorXd rounding = rounding_of(*problem.rows, x);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const Bounds& bounds = problem.rows->bounds()[static_cast<std::size_t>(i)];
    EXPECT_LE(bounds.lower - rows(i), rounding(i)) << "row " << i;
    EXPECT_LE(rows(i) - bounds.upper, rounding(i)) << "row " << i;
  }
}

TEST_P(HockSchittkowski, EndsAtAnOptimumFromThePublishedStart) {
  const PublishedProblem& problem = GetParam();
  const NonlinearSolution solution = solve(program_of(problem, problem.start, {}), {});
  ASSERT_EQ(solution.status, NonlinearStatus::kSolved);
  expect_first_order_conditions(problem, solution);
  EXPECT_NEAR(solution.objective, problem.found,
              allowed_gap(solution) + problem.printed * size_of(problem.found));
  EXPECT_EQ(solution.objective, values_of(*problem.cost, vector_of(solution.values))(0));
}

TEST_P(HockSchittkowski, EndsAtThePublishedOptimumFromNearby) {
  const PublishedProblem& problem = GetParam();
  std::vector<double> start = problem.minimiser;
  for (std::size_t i = 0; i < start.size(); ++i) {
    start[i] += (i % 2 == 0 ? 1e-3 : -1e-3) * size_of(start[i]);
  }
  NonlinearOptions options;
  options.first_barrier = 1e-4;
  const NonlinearSolution solution = solve(program_of(problem, start, {}), options);
  ASSERT_EQ(solution.status, NonlinearStatus::kSolved);
  expect_first_order_conditions(problem, solution);
  EXPECT_NEAR(solution.objective, problem.optimum,
              allowed_gap(solution) + problem.printed * size_of(problem.optimum));
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(solution.values[i], problem.minimiser[i],
                problem.reach * size_of(problem.minimiser[i]))
        << i;
  }
}

// Scales change where a search goes and what it tolerates, not what holds where it ends.
TEST_P(HockSchittkowski, EndsAtAnOptimumOnOtherScales) {
  const PublishedProblem& problem = GetParam();
  const OtherScales scales = {8.0, 4.0, 16.0};
  const NonlinearSolution solution = solve(program_of(problem, problem.minimiser, scales), {});
  ASSERT_EQ(solution.status, NonlinearStatus::kSolved);
  expect_first_order_conditions(problem, solution, scales);
}

INSTANTIATE_TEST_SUITE_P(Published, HockSchittkowski, testing::ValuesIn(every_published_problem()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace torquewright::optimization
