// SPDX-License-Identifier: Apache-2.0
// Oracles: the double integrator's gain in closed form, Riccati's equation itself, the cost of a
// simulated run, the recursion run long enough, and that over a state that holds constants too.
#include "hopper/tracking/riccati.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torquewright::hopper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// x'' = u, held over a period; costs x^2 + r u^2 a second.
LinearStep double_integrator(double period_s, double r) {
  LinearStep step;
  step.A = (MatrixXd(2, 2) << 1, period_s, 0, 1).finished();
  step.B = (MatrixXd(2, 1) << 0.5 * period_s * period_s, period_s).finished();
  step.Q = period_s * (MatrixXd(2, 2) << 1, 0, 0, 0).finished();
  step.R = MatrixXd::Constant(1, 1, period_s * r);
  return step;
}

/// An unstable state of three with two inputs; no structure.
LinearStep some_step() {
  LinearStep step;
  step.A = (MatrixXd(3, 3) << 1.2, 0.3, -0.1, 0.0, 0.9, 0.4, 0.2, -0.1, 1.05).finished();
  step.B = (MatrixXd(3, 2) << 0.1, 0.0, 0.3, -0.2, 0.0, 0.5).finished();
  step.Q = (MatrixXd(3, 3) << 2, 0.1, 0, 0.1, 1, 0, 0, 0, 0.5).finished();
  step.R = (MatrixXd(2, 2) << 0.7, 0.1, 0.1, 0.4).finished();
  return step;
}

// Without holding K = (r^-1/2, sqrt(2) r^-1/4), from s^4 + 1/r = 0; holding torque over a
// period is off in proportion to it.
TEST(SteadyRiccati, IsTheDoubleIntegratorsGainAsPeriodsShrink) {
  constexpr double kR = 0.05;
  const double position = 1.0 / std::sqrt(kR), speed = std::sqrt(2.0) * std::pow(kR, -0.25);
  double coarse_off[2] = {};
  for (const double period_s : {4e-3, 2e-3, 1e-3}) {
    const auto steady = steady_riccati(double_integrator(period_s, kR));
    ASSERT_TRUE(steady);
    const double off[2] = {steady->gain(0, 0) / position - 1.0, steady->gain(0, 1) / speed - 1.0};
    for (int i = 0; i < 2; ++i) {
      EXPECT_LT(std::abs(off[i]), 5.0 * period_s);  // closed loop at r^-1/4 = 2.1 rad/s
      if (coarse_off[i] != 0.0) {
        EXPECT_NEAR(coarse_off[i] / off[i], 2.0, 0.05);
      }
      coarse_off[i] = off[i];
    }
  }
}

TEST(SteadyRiccati, SolvesItsEquation) {
  const LinearStep step = some_step();
  const auto steady = steady_riccati(step);
  ASSERT_TRUE(steady);
  const MatrixXd& P = steady->cost;
  const MatrixXd BPA = step.B.transpose() * P * step.A;
  const MatrixXd BPB = step.R + step.B.transpose() * P * step.B;
  const MatrixXd again =
      step.Q + step.A.transpose() * P * step.A - BPA.transpose() * BPB.inverse() * BPA;
  EXPECT_LT((again - P).norm(), 1e-12 * P.norm());
  EXPECT_LT((steady->gain - BPB.inverse() * BPA).norm(), 1e-12 * steady->gain.norm());
}

// 400 steps: what is left decays as the closed loop's greatest eigenvalue, below 0.9, squared.
TEST(SteadyRiccati, IsWhereTheRecursionArrives) {
  const LinearStep step = some_step();
  const auto steady = steady_riccati(step);
  ASSERT_TRUE(steady);
  MatrixXd cost = MatrixXd::Identity(3, 3);
  for (int i = 0; i < 400; ++i) cost = riccati_step(step, cost).cost;
  EXPECT_LT((cost - steady->cost).norm(), 1e-12 * cost.norm());
}

TEST(SteadyRiccati, CostIsWhatARunCosts) {
  const LinearStep step = some_step();
  const auto steady = steady_riccati(step);
  ASSERT_TRUE(steady);
  VectorXd x = (VectorXd(3) << 0.3, -1.0, 0.7).finished();
  const double foretold = x.dot(steady->cost * x);
  double paid = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const VectorXd u = -steady->gain * x;
    paid += x.dot(step.Q * x) + u.dot(step.R * u);
    x = (step.A * x + step.B * u).eval();
  }
  EXPECT_NEAR(paid, foretold, 1e-12 * foretold);
}

// Just inside and just outside of what an input can hold.
TEST(SteadyRiccati, IsNoneWhereNothingHoldsTheState) {
  LinearStep step;
  step.Q = step.R = MatrixXd::Identity(1, 1);
  step.B = MatrixXd::Zero(1, 1);
  for (const double a : {1.0, 1.001, 2.0}) {
    step.A = MatrixXd::Constant(1, 1, a);
    EXPECT_FALSE(steady_riccati(step)) << a;
  }
  step.A = MatrixXd::Constant(1, 1, 0.999);
  const auto decaying = steady_riccati(step);
  ASSERT_TRUE(decaying);  // 1 + a^2 + a^4 + ...
  EXPECT_NEAR(decaying->cost(0, 0), 1.0 / (1.0 - 0.999 * 0.999), 1e-9);
}

// A step onto fewer numbers: 1/2 (x + y) goes on, u can cancel it. By hand: P+ = 4, R = 1, B = 1:
// gain 4/5 [1/2 1/2], cost 4/5 [1/2 1/2]^T [1/2 1/2].
TEST(RiccatiStep, MayChangeTheStatesSize) {
  LinearStep step;
  step.A = MatrixXd::Constant(1, 2, 0.5);
  step.B = step.R = MatrixXd::Identity(1, 1);
  step.Q = MatrixXd::Zero(2, 2);
  const RiccatiStep back = riccati_step(step, MatrixXd::Constant(1, 1, 4.0));
  EXPECT_LT((back.gain - MatrixXd::Constant(1, 2, 0.4)).norm(), 1e-15);
  EXPECT_LT((back.cost - MatrixXd::Constant(2, 2, 0.2)).norm(), 1e-15);
}

MatrixXd some_drift() { return (MatrixXd(3, 2) << 0.2, -0.1, 0.0, 0.3, 0.5, 0.1).finished(); }

TEST(ConstantStep, IsTheStepOfAStateThatHoldsTheConstants) {
  const LinearStep step = some_step();
  const MatrixXd drift = some_drift();
  LinearStep joined = step;
  joined.A.setIdentity(5, 5);
  joined.A.topLeftCorner(3, 3) = step.A;
  joined.A.topRightCorner(3, 2) = drift;
  joined.B.setZero(5, 2);
  joined.B.topRows(3) = step.B;
  joined.Q.setZero(5, 5);
  joined.Q.topLeftCorner(3, 3) = step.Q;
  MatrixXd cost = MatrixXd::Identity(3, 3), constant_cost = MatrixXd::Zero(3, 2);
  MatrixXd joined_cost = MatrixXd::Zero(5, 5);
  joined_cost.topLeftCorner(3, 3) = cost;
  for (int i = 0; i < 20; ++i) {
    const RiccatiStep together = riccati_step(joined, joined_cost);
    const RiccatiStep regulated = riccati_step(step, cost);
    const ConstantStep constant = constant_step(step, drift, regulated, cost, constant_cost);
    joined_cost = together.cost;
    cost = regulated.cost;
    constant_cost = constant.cost;
    EXPECT_LT((constant.gain - together.gain.rightCols(2)).norm(), 1e-12);
    EXPECT_LT((constant_cost - joined_cost.topRightCorner(3, 2)).norm(), 1e-11);
  }
}

TEST(SteadyConstant, IsWhereTheStepsArrive) {
  const LinearStep step = some_step();
  const auto steady = steady_riccati(step);
  ASSERT_TRUE(steady);
  const ConstantStep found = steady_constant(step, some_drift(), *steady);
  MatrixXd cost = MatrixXd::Zero(3, 2);
  for (int i = 0; i < 400; ++i) {
    cost = constant_step(step, some_drift(), *steady, steady->cost, cost).cost;
  }
  EXPECT_LT((found.cost - cost).norm(), 1e-12 * cost.norm());
  EXPECT_EQ(steady_constant(step, MatrixXd(3, 0), *steady).gain.cols(), 0);
}

}  // namespace
}  // namespace torquewright::hopper
