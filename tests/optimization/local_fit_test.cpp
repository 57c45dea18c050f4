// SPDX-License-Identifier: Apache-2.0
// Oracles: optima in closed form.
#include "optimization/fit/local_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace torquewright::optimization {
namespace {

using Parameters = std::span<const double>;

constexpr FitMethod kMethods[] = {FitMethod::kQuadraticModels, FitMethod::kSubspaces};
/// A point is found to the tolerance asked for (1e-6 of a box of width 4), times the valley's
/// narrowness: Rosenbrock's Hessian has a condition of 2500, so the point is known to its root
/// less.
constexpr double kPointTolerance = 1e-6 * 4.0 * 50.0;

TEST(LocalFit, FindsRosenbrocksValleyFloorInABox) {
  for (const FitMethod method : kMethods) {
    FitOptions options;
    options.method = method;
    options.tolerance = 1e-8;
    options.most_evaluations = 20000;
    const LocalFit fit = fit_locally(
        [](Parameters x) {
          return 100.0 * std::pow(x[1] - x[0] * x[0], 2.0) + std::pow(1.0 - x[0], 2.0);
        },
        {{-2.0, 2.0, -1.2}, {-2.0, 2.0, 1.0}}, options);
    EXPECT_NEAR(fit.point[0], 1.0, kPointTolerance);
    EXPECT_NEAR(fit.point[1], 1.0, kPointTolerance);
    EXPECT_NE(fit.stop, FitStop::kFailed);
    EXPECT_EQ(fit.starts.size(), 5U);
  }
}

// min (x-3)^2 + 2 (y+1)^2 + (x-3)(y+1) on [0, 2] x [-2, 2]: x ends at 2, where 4 (y+1) = 1.
TEST(LocalFit, StopsAtABoundThatIsActive) {
  for (const FitMethod method : kMethods) {
    FitOptions options;
    options.method = method;
    const LocalFit fit = fit_locally(
        [](Parameters x) {
          const double a = x[0] - 3.0;
          const double b = x[1] + 1.0;
          return a * a + 2.0 * b * b + a * b;
        },
        {{0.0, 2.0, 0.5}, {-2.0, 2.0, 0.0}}, options);
    EXPECT_DOUBLE_EQ(fit.point[0], 2.0);
    EXPECT_NEAR(fit.point[1], -0.75, kPointTolerance);
    EXPECT_NEAR(fit.value, 1.0 - 0.125, 1e-9);
    EXPECT_EQ(fit.agreeing, 5U);
  }
}

// x^4 - 2 x^2 + 0.3 x: two valleys, the left one deeper. From the right one a single start stays.
TEST(LocalFit, SeveralStartsFindTheDeeperValley) {
  const auto objective = [](Parameters x) {
    return std::pow(x[0], 4.0) - 2.0 * x[0] * x[0] + 0.3 * x[0];
  };
  FitOptions one;
  one.starts = 1;
  const std::vector<FitVariable> variables{{-2.0, 2.0, 0.9}};
  EXPECT_GT(fit_locally(objective, variables, one).point[0], 0.0);
  const LocalFit fit = fit_locally(objective, variables);
  // Root of 4 x^3 - 4 x + 0.3 near -1, by Cardano: 2/sqrt(3) cos(...).
  const double root = 2.0 / std::sqrt(3.0) *
                      std::cos(std::acos(-0.075 * 1.5 * std::sqrt(3.0)) / 3.0 + 2.0 * M_PI / 3.0);
  EXPECT_NEAR(fit.point[0], root, kPointTolerance);
  EXPECT_GT(fit.value_spread, 0.5);  // the other valley lies 0.6 higher
  EXPECT_LT(fit.agreeing, fit.starts.size());
}

// What is not determined shows as a spread: only the sum of x and y matters.
TEST(LocalFit, ShowsAValleyBySpread) {
  const LocalFit fit =
      fit_locally([](Parameters x) { return std::pow(x[0] + x[1] - 1.0, 2.0) + 1.0; },
                  {{0.0, 1.0, 0.1}, {0.0, 1.0, 0.9}});
  EXPECT_EQ(fit.agreeing, 5U);
  EXPECT_GT(fit.point_spread[0], 0.2);
}

// (ln x - ln 0.01)^2 has its minimum at 0.01, five decades from the bound.
TEST(LocalFit, SearchesLogarithmicallyAndKeepsFixedValues) {
  const LocalFit fit =
      fit_locally([](Parameters x) { return std::pow(std::log(x[0] / 0.01), 2.0) + x[1]; },
                  {{1e-7, 1e3, 1.0, true}, {4.0, 4.0, 4.0}});
  EXPECT_NEAR(std::log(fit.point[0] / 0.01), 0.0, 1e-4);
  EXPECT_EQ(fit.point[1], 4.0);
  EXPECT_EQ(fit.point_spread[1], 0.0);
}

TEST(LocalFit, AvoidsWhereNothingIsFinite) {
  const LocalFit fit = fit_locally(
      [](Parameters x) {
        if (x[0] > 0.6) return std::numeric_limits<double>::quiet_NaN();
        return std::pow(x[0] - 0.5, 2.0) + std::pow(x[1] - 0.2, 2.0);
      },
      {{0.0, 1.0, 0.1}, {0.0, 1.0, 0.1}});
  EXPECT_NEAR(fit.point[0], 0.5, 1e-3);
  const LocalFit none = fit_locally(
      [](Parameters) { return std::numeric_limits<double>::quiet_NaN(); }, {{0.0, 1.0, 0.1}});
  EXPECT_EQ(none.stop, FitStop::kFailed);
}

TEST(LocalFit, SaysWhyItStopped) {
  FitOptions options;
  options.most_evaluations = 7;
  const auto objective = [](Parameters x) { return std::pow(x[0] - 0.3, 2.0) * std::exp(x[1]); };
  const LocalFit fit = fit_locally(objective, {{0.0, 1.0, 0.9}, {0.0, 1.0, 0.5}}, options);
  EXPECT_EQ(fit.stop, FitStop::kEvaluationLimit);
  EXPECT_LE(fit.starts[0].evaluations, 7U);
  EXPECT_EQ(name_of(fit.stop), "evaluation_limit");
  EXPECT_EQ(name_of(FitStop::kConverged), "converged");
  EXPECT_EQ(name_of(FitStop::kRoundOff), "round_off");
  EXPECT_EQ(name_of(FitStop::kFailed), "failed");
}

TEST(LocalFit, FixedVariablesNeedOneEvaluation) {
  const LocalFit fit = fit_locally([](Parameters x) { return 2.0 * x[0]; }, {{3.0, 3.0, 3.0}});
  EXPECT_EQ(fit.value, 6.0);
  EXPECT_EQ(fit.evaluations, 1U);
}

TEST(LocalFit, PassesOnWhatTheObjectiveThrowsAndRefusesBadBoxes) {
  const auto throws = [](Parameters) -> double { throw std::domain_error("mine"); };
  EXPECT_THROW(fit_locally(throws, {{0.0, 1.0, 0.5}}), std::domain_error);
  const auto zero = [](Parameters) { return 0.0; };
  EXPECT_THROW(fit_locally(zero, {{1.0, 0.0, 0.5}}), std::invalid_argument);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(fit_locally(zero, {{0.0, infinity, 0.5}}), std::invalid_argument);
  EXPECT_THROW(fit_locally(zero, {{0.0, 1.0, 0.5, true}}), std::invalid_argument);
}

TEST(LocalFit, TheSameQuestionHasTheSameAnswer) {
  const auto objective = [](Parameters x) { return std::cos(9.0 * x[0]) + std::sin(7.0 * x[1]); };
  const std::vector<FitVariable> variables{{0.0, 1.0, 0.5}, {0.0, 1.0, 0.5}};
  EXPECT_EQ(fit_locally(objective, variables).point, fit_locally(objective, variables).point);
}

}  // namespace
}  // namespace torquewright::optimization
