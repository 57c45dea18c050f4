// SPDX-License-Identifier: Apache-2.0
// Mechanisms on numbers with derivatives. Oracles: identities between a mechanism's own outputs,
// which are separate closed forms (J = dx/dq, J' = dJ/dq q'), and fourth-order differences of the
// double version.
#include <gtest/gtest.h>

#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/mechanisms/four_bar.hpp"
#include "tests/robot/mechanisms/ankles.hpp"
#include "tests/robot/mechanisms/derivatives.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::Jet;
using dynamics::Jet2;
using oracles::Dice;
using test::pair_of;
using test::slope;
using test::uniform;

/// Variables: positions, then speeds.
template <typename T>
std::optional<TransferOf<T>> seeded_transfer(const Mechanism& mechanism, const SmallVector& q,
                                             const SmallVector& v) {
  const auto k = static_cast<int>(q.size());
  SmallVectorOf<T> joint_rad(k), joint_rad_s(k);
  for (int j = 0; j < k; ++j) {
    joint_rad[j] = T::variable(q[j], j);
    joint_rad_s[j] = T::variable(v[j], k + j);
  }
  return transfer_of<T>(mechanism, joint_rad, joint_rad_s);
}

/// What holds but for rounding.
void expect_identities(const TransferOf<Jet2>& at, const Transfer& plain, const SmallVector& v,
                       double tolerance) {
  const auto k = static_cast<int>(v.size());
  for (int i = 0; i < k; ++i) {
    EXPECT_NEAR(at.actuator_position_rad[i].value(), plain.actuator_position_rad[i], 1e-12);
    for (int j = 0; j < k; ++j) {
      const Jet2& jacobian = at.jacobian(i, j);
      EXPECT_NEAR(jacobian.value(), plain.jacobian(i, j), tolerance);
      EXPECT_NEAR(at.actuator_position_rad[i].slope(j), jacobian.value(), tolerance);
      double rate = 0;
      for (int l = 0; l < k; ++l) {
        rate += jacobian.slope(l) * v[l];
        EXPECT_NEAR(at.actuator_position_rad[i].curvature(j, l), jacobian.slope(l), tolerance);
        EXPECT_NEAR(at.jacobian_rate_1_s(i, j).slope(k + l), jacobian.slope(l), tolerance);
        EXPECT_EQ(jacobian.slope(k + l), 0);
      }
      EXPECT_NEAR(at.jacobian_rate_1_s(i, j).value(), rate, tolerance);
    }
  }
}

void expect_differences(const Mechanism& mechanism, const TransferOf<Jet>& at, const SmallVector& q,
                        const SmallVector& v, double tolerance) {
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const SmallMatrix bent = slope([&](double step) -> SmallMatrix {
      SmallVector there = q;
      there[j] += step;
      return mechanism.transfer(there, v)->jacobian_rate_1_s;
    });
    for (Eigen::Index row = 0; row < q.size(); ++row) {
      for (Eigen::Index column = 0; column < q.size(); ++column) {
        EXPECT_NEAR(at.jacobian_rate_1_s(row, column).slope(static_cast<int>(j)), bent(row, column),
                    tolerance);
      }
    }
  }
}

/// Far from where derivatives grow without bound; tells whether it was.
bool expect_derivatives_of(const Mechanism& mechanism, const SmallVector& q, const SmallVector& v) {
  const auto plain = mechanism.transfer(q, v);
  const auto second = seeded_transfer<Jet2>(mechanism, q, v);
  EXPECT_EQ(plain.has_value(), second.has_value());
  for (const MechanismMargin& margin : mechanism.margins(q)) {
    const double far = margin.unit == "m" ? 0.01 : 0.4;
    if (margin.name != "least_lever" && margin.margin < far) return false;
  }
  if (!plain || !second) return false;
  const auto first = seeded_transfer<Jet>(mechanism, q, v);
  const double bend = 1 + plain->jacobian.squaredNorm() + plain->jacobian_rate_1_s.squaredNorm();
  expect_identities(*second, *plain, v, 1e-12 * bend);
  expect_differences(mechanism, *first, q, v, 1e-8 * bend);
  return true;
}

TEST(MechanismJet, OfFourBars) {
  Dice dice(51);
  int far = 0;
  for (int i = 0; i < 2000; ++i) {
    FourBarGeometry links;
    do {
      links.crank_m = uniform(dice, 0.4, 2);
      links.coupler_m = uniform(dice, 0.4, 2);
      links.rocker_m = uniform(dice, 0.4, 2);
      links.ground_m = uniform(dice, 0.4, 2);
    } while (four_bar_objection(links));
    links.rocker_zero_rad = uniform(dice, -3, 3);
    links.crank_direction = dice.chance(50) ? 1 : -1;
    links.rocker_direction = dice.chance(50) ? 1 : -1;
    links.branch = dice.chance(50) ? 1 : -1;
    const SmallVector q = SmallVector::Constant(1, uniform(dice, -3, 3));
    const SmallVector v = SmallVector::Constant(1, uniform(dice, -3, 3));
    if (expect_derivatives_of(FourBar(links), q, v)) ++far;
  }
  EXPECT_GT(far, 200);
}

TEST(MechanismJet, OfParallelAnkles) {
  Dice dice(52);
  int far = 0;
  for (int i = 0; i < 500; ++i) {
    ParallelAnkleGeometry geometry = test::askew_ankle(dice);
    geometry.rod_tilt_limit_rad = 1.5;
    geometry.transmission_limit_rad = 0;
    const SmallVector q = pair_of(uniform(dice, -0.5, 0.5), uniform(dice, -0.3, 0.3));
    const SmallVector v = pair_of(uniform(dice, -3, 3), uniform(dice, -3, 3));
    if (expect_derivatives_of(ParallelAnkle(geometry), q, v)) ++far;
  }
  EXPECT_GT(far, 100);
}

// Oracle: what is the same in every posture has no slope.
TEST(MechanismJet, OfConstantJacobiansAndParallelograms) {
  SmallMatrix jacobian(2, 2);
  jacobian << 1, 0.5, 1, -0.5;
  const ConstantJacobian pair("parallel", jacobian);
  EXPECT_TRUE(expect_derivatives_of(pair, pair_of(0.3, -0.2), pair_of(2, 3)));
  FourBarGeometry links;
  links.crank_m = links.rocker_m = 0.05;
  links.coupler_m = links.ground_m = 0.15;
  links.crank_direction = -1;
  const SmallVector q = SmallVector::Constant(1, 1.2), v = SmallVector::Constant(1, 7);
  const auto at = seeded_transfer<Jet2>(FourBar(links), q, v);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->jacobian(0, 0).value(), -1);
  EXPECT_EQ(at->jacobian(0, 0).count(), 0);
  EXPECT_EQ(at->actuator_position_rad[0].slope(0), -1);
}

}  // namespace
}  // namespace torquewright::hopper
