// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::test {

/// The derivative at 0 of a function of one number: central differences of fourth order. Steps of
/// 2e-4 leave some 1e-15 times its fifth derivative, and 1e-12 of rounding.
template <typename Function>
auto slope(const Function& f) {
  constexpr double h = 2e-4;
  using Value = std::decay_t<decltype(f(h))>;
  return Value((8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h));
}

/// Oracle: differences of the mechanism's own positions and Jacobians.
inline void expect_derivatives(const hopper::Mechanism& mechanism, const hopper::SmallVector& q,
                               const hopper::SmallVector& v) {
  using hopper::SmallMatrix;
  using hopper::SmallVector;
  constexpr double kTolerance = 2e-9;
  const auto here = mechanism.transfer(q, v);
  ASSERT_TRUE(here);
  const double scale = 1 + here->jacobian.cwiseAbs().maxCoeff();
  for (Eigen::Index j = 0; j < mechanism.size(); ++j) {
    const SmallVector change = slope([&](double step) -> SmallVector {
      SmallVector there = q;
      there[j] += step;
      SmallVector turned = mechanism.transfer(there, v).value().actuator_position_rad;
      turned -= here->actuator_position_rad;
      for (double& angle : turned) angle = std::remainder(angle, 2 * M_PI);
      return turned;
    });
    EXPECT_LE((here->jacobian.col(j) - change).cwiseAbs().maxCoeff(), kTolerance * scale);
  }
  const SmallMatrix rate = slope(
      [&](double step) -> SmallMatrix { return mechanism.transfer(q + step * v, v)->jacobian; });
  const double speed = 1 + v.squaredNorm();
  EXPECT_LE((here->jacobian_rate_1_s - rate).cwiseAbs().maxCoeff(), kTolerance * scale * speed);
}

}  // namespace torquewright::test
