// SPDX-License-Identifier: Apache-2.0
// Oracles: polynomials, of which the rule is exact up to cubics; sin(t), of which the remainders of
// Simpson's and Hermite's rules are known; differences of values.
#include "hopper/planning/plane/hermite_simpson.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShare = 0.4;

HermiteSimpson rows_of() { return {"y", {4, 7, 1, 3, 0, 8, 11}, kShare, 2.0}; }

/// y and its rate over kShare T, from t on.
VectorXd values_of(const std::function<double(double)>& y,
                   const std::function<double(double)>& rate, double t, double T) {
  const double h = kShare * T;
  VectorXd x(7);
  x << y(t), y(t + 0.5 * h), y(t + h), rate(t), rate(t + 0.5 * h), rate(t + h), T;
  return x;
}

VectorXd residual(const VectorXd& x) {
  VectorXd rows(2);
  rows_of().values(x, rows);
  return rows;
}

TEST(HermiteSimpson, IsExactForCubics) {
  oracles::Dice dice(1);
  for (int sample = 0; sample < 20; ++sample) {
    const VectorXd c = test::uniform_vector(dice, 4, 3);
    const auto y = [&c](double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); };
    const auto rate = [&c](double t) { return c[1] + t * (2 * c[2] + t * 3 * c[3]); };
    const double t = test::uniform(dice, -1, 1), T = test::uniform(dice, 0.1, 2);
    EXPECT_LT(residual(values_of(y, rate, t, T)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(HermiteSimpson, LeavesTheRemaindersOfItsRules) {
  // Simpson: -h^5/2880 of the rate's fourth derivative, in the integral less the rule; Hermite at
  // the middle: h^4/384 of y's fourth. The next terms are h^2 smaller: of sin, below 1 % of it.
  for (const double h : {0.1, 0.05, 0.025}) {
    const auto y = [](double t) { return std::sin(t); };
    const auto rate = [](double t) { return std::cos(t); };
    const double t = 0.7, middle = t + 0.5 * h;
    const VectorXd rows = residual(values_of(y, rate, t, h / kShare));
    const double simpson = -std::pow(h, 5) / 2880.0 * std::cos(middle);
    const double hermite = std::pow(h, 4) / 384.0 * std::sin(middle);
    EXPECT_NEAR(rows[0], simpson, 0.01 * std::abs(simpson));
    EXPECT_NEAR(rows[1], hermite, 0.01 * std::abs(hermite));
  }
}

TEST(HermiteSimpson, NoticesEachOfItsVariables) {
  const auto y = [](double t) { return 1.0 + t + t * t; };
  const auto rate = [](double t) { return 1.0 + 2.0 * t; };
  for (Index i = 0; i < 7; ++i) {
    VectorXd x = values_of(y, rate, 0.3, 1.0);
    x[i] += 0.1;
    EXPECT_GT(residual(x).cwiseAbs().maxCoeff(), 1e-3) << i;
  }
}

TEST(HermiteSimpson, HasTheSlopesOfItsValues) {
  // Polynomials of degree two in any one variable: central differences are exact but for eps/h.
  constexpr double h = 1e-3;
  oracles::Dice dice(4);
  const HermiteSimpson rows = rows_of();
  for (int sample = 0; sample < 5; ++sample) {
    const VectorXd x = test::uniform_vector(dice, 7, 2),
                   multipliers = test::uniform_vector(dice, 2, 2);
    MatrixXd slopes = MatrixXd::Constant(2, 7, NAN), curvatures = MatrixXd::Constant(7, 7, NAN);
    rows.slopes(x, slopes);
    rows.curvatures(x, multipliers, curvatures);
    for (Index i = 0; i < 7; ++i) {
      const VectorXd step = h * VectorXd::Unit(7, i);
      const VectorXd by_difference = (residual(x + step) - residual(x - step)) / (2 * h);
      EXPECT_LT((slopes.col(i) - by_difference).norm(), 1e-11);
      MatrixXd after(2, 7), before(2, 7);
      rows.slopes(x + step, after);
      rows.slopes(x - step, before);
      const VectorXd bend = (after - before).transpose() * multipliers / (2 * h);
      EXPECT_LT((curvatures.col(i) - bend).norm(), 1e-11);
    }
  }
}

TEST(HermiteSimpson, IsAnEquationOfTheScaleItWasGiven) {
  const HermiteSimpson rows = rows_of();
  ASSERT_EQ(rows.size(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(rows.bounds()[i].lower, 0.0);
    EXPECT_EQ(rows.bounds()[i].upper, 0.0);
    EXPECT_EQ(rows.scales()[i], 2.0);
  }
}

}  // namespace
}  // namespace torquewright::hopper
