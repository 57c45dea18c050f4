// SPDX-License-Identifier: Apache-2.0
#include "robot/mechanisms/four_bar.hpp"

#include <gtest/gtest.h>

#include "tests/robot/mechanisms/ankles.hpp"
#include "tests/robot/mechanisms/derivatives.hpp"
#include "tests/robot/mechanisms/four_bars.hpp"
#include "tests/robot/mechanisms/joint_position.hpp"

namespace torquewright::hopper {
namespace {

using oracles::Dice;
using test::margin_of;
using test::uniform;

SmallVector one(double value) { return SmallVector::Constant(1, value); }

/// Of a Grashof crank-rocker: 1 + 3.5 < 2.5 + 3.
FourBarGeometry crank_rocker() {
  FourBarGeometry links;
  links.crank_m = 1;
  links.coupler_m = 3;
  links.rocker_m = 2.5;
  links.ground_m = 3.5;
  return links;
}

FourBarGeometry parallelogram() {
  FourBarGeometry links;
  links.crank_m = links.rocker_m = 0.05;
  links.coupler_m = links.ground_m = 0.15;
  return links;
}

/// Freudenstein's equation (1955), K1 cos psi - K2 cos phi + K3 = cos(phi - psi), as left minus
/// right.
double freudenstein(const FourBarGeometry& links, double phi, double psi) {
  const double a = links.crank_m, b = links.coupler_m, c = links.rocker_m, d = links.ground_m;
  return d / a * std::cos(psi) - d / c * std::cos(phi) +
         (a * a - b * b + c * c + d * d) / (2 * a * c) - std::cos(phi - psi);
}

FourBarGeometry drawn(Dice& dice) {
  FourBarGeometry links;
  do {
    links.crank_m = uniform(dice, 0.1, 2);
    links.coupler_m = uniform(dice, 0.1, 2);
    links.rocker_m = uniform(dice, 0.1, 2);
    links.ground_m = uniform(dice, 0.1, 2);
  } while (four_bar_objection(links));
  test::mount_anyhow(dice, links);
  return links;
}

// Oracles: Freudenstein's equation; central differences.
TEST(FourBar, KeepsFreudensteinsEquationAndItsDerivatives) {
  Dice dice(5);
  int reached = 0;
  for (int i = 0; i < 3000; ++i) {
    const FourBarGeometry links = drawn(dice);
    const FourBar four_bar(links);
    const SmallVector q = one(uniform(dice, -3, 3)), v = one(uniform(dice, -3, 3));
    const auto at = four_bar.transfer(q, v);
    bool is_far = true;  // where curvature leaves differences their digits
    for (const MechanismMargin& margin : four_bar.margins(q)) {
      is_far = is_far && margin.margin > 0.3;
    }
    if (!at) continue;
    ++reached;
    const double phi = links.crank_zero_rad + links.crank_direction * at->actuator_position_rad[0];
    const double psi = links.rocker_zero_rad + links.rocker_direction * q[0];
    const double scale = links.ground_m / std::min(links.crank_m, links.rocker_m) + 20;
    EXPECT_NEAR(freudenstein(links, phi, psi), 0, 1e-13 * scale * scale);
    if (is_far) test::expect_derivatives(four_bar, q, v);
  }
  EXPECT_GT(reached, 1000);
}

// Oracle: triangles by hand. With the rocker at 120 degrees its pin is at (2.25, 2.165), r^2
// = 9.75, and the crank stands at atan2(2.165, 2.25) +- acos((1 + 9.75 - 9)/(2 r)).
TEST(FourBar, StandsWhereTheTriangleSays) {
  FourBarGeometry links = crank_rocker();
  const double r = std::sqrt(9.75);
  for (const int branch : {1, -1}) {
    links.branch = branch;
    const auto at = FourBar(links).transfer(one(M_PI * 2 / 3), one(0));
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->actuator_position_rad[0],
                std::atan2(1.25 * std::sqrt(3), 2.25) + branch * std::acos(1.75 / (2 * r)), 1e-14);
  }
}

// Oracle: the rocker swings between crank and coupler stretched, |pin| = 4, and folded, |pin| = 2:
// cos psi = (16 - 18.5)/17.5 and (4 - 18.5)/17.5, by the law of cosines.
TEST(FourBar, NamesTheEndsOfItsReach) {
  const FourBar four_bar(crank_rocker());
  const double stretched = std::acos(-2.5 / 17.5), folded = std::acos(-14.5 / 17.5);
  for (const double off : {1e-6, 0.1}) {
    EXPECT_TRUE(four_bar.transfer(one(folded - off), one(0)));
    EXPECT_FALSE(four_bar.transfer(one(folded + off), one(0)));
  }
  const auto inside = four_bar.margins(one(folded - 0.1));
  ASSERT_TRUE(margin_of(inside, "reach_folded"));
  EXPECT_NEAR(margin_of(inside, "reach_folded")->margin, 0.1, 1e-14);
  EXPECT_NEAR(margin_of(inside, "reach_stretched")->margin, folded - 0.1 - stretched, 1e-14);
  const auto outside = four_bar.margins(one(folded + 0.1));
  EXPECT_NEAR(margin_of(outside, "reach_folded")->margin, -0.1, 1e-14);
  EXPECT_FALSE(margin_of(outside, "transmission_angle"));
  for (const double psi : {stretched + 1e-5, folded - 1e-5}) {  // crank and coupler in line
    EXPECT_LE(margin_of(four_bar.margins(one(psi)), "crank_dead_centre")->margin, 0.02);
  }
}

// Oracle: rocker and coupler in line, |crank's pin to rocker's pivot| = 2.1 + 1.2: the crank of a
// double rocker ends there, and its ratio is zero. cos phi = (a^2 + d^2 - (b + c)^2)/(2 a d).
TEST(FourBar, NamesTheDeadCentreOfTheRocker) {
  FourBarGeometry links;
  links.crank_m = 2;
  links.coupler_m = 2.1;
  links.rocker_m = 1.2;
  links.ground_m = 2;
  links.transmission_limit_rad = 0.52;
  links.branch = 1;
  const double phi = std::acos((4 + 4 - 3.3 * 3.3) / 8);
  const Eigen::Vector2d pin(2 * std::cos(phi), 2 * std::sin(phi));
  const double psi = std::atan2(pin.y(), pin.x() - 2);
  const FourBar four_bar(links);
  const auto margins = four_bar.margins(one(psi));
  ASSERT_TRUE(margin_of(margins, "rocker_dead_centre"));
  EXPECT_NEAR(margin_of(margins, "rocker_dead_centre")->margin, 0, 1e-7);
  EXPECT_NEAR(margin_of(margins, "transmission_angle")->margin, -0.52, 1e-7);
  const auto near = four_bar.transfer(one(psi + 1e-4), one(0));
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->jacobian(0, 0), 0, 1e-3);
  EXPECT_NEAR(near->actuator_position_rad[0], phi, 1e-7);
}

// Oracle: geometry of parallels. Not one rounding away from 1:1, on either side of its change
// points, which are where all links lie in line; the crossed linkage meets it there.
TEST(FourBar, ThatIsAParallelogramIsOneToOneExactly) {
  FourBarGeometry links = parallelogram();
  links.crank_zero_rad = links.rocker_zero_rad = 0.4363;
  for (const int direction : {1, -1}) {
    links.crank_direction = direction;
    const FourBar four_bar(links);
    for (double q = -3; q < 3; q += 0.0371) {
      const auto at = four_bar.transfer(one(q), one(7));
      ASSERT_TRUE(at);
      EXPECT_EQ(at->actuator_position_rad[0], direction * q);
      EXPECT_EQ(at->jacobian(0, 0), direction);
      EXPECT_EQ(at->jacobian_rate_1_s(0, 0), 0);
    }
    EXPECT_FALSE(four_bar.transfer(one(-0.4363), one(0)));
    ASSERT_TRUE(four_bar.constant_jacobian());
  }
  const auto margins = FourBar(links).margins(one(0.1));
  EXPECT_NEAR(margin_of(margins, "change_point_stretched")->margin, 0.5363, 1e-15);
  EXPECT_NEAR(margin_of(margins, "change_point_folded")->margin, M_PI - 0.5363, 1e-15);
  EXPECT_NEAR(margin_of(margins, "transmission_angle")->value, 0.5363, 1e-14);
  const auto beyond = FourBar(links).margins(one(-1));
  EXPECT_NEAR(margin_of(beyond, "transmission_angle")->value, 0.5637, 1e-14);
  EXPECT_NEAR(margin_of(beyond, "crank_dead_centre")->value, 0.5637, 1e-14);
  // An arc cosine would lose half of the digits here.
  const auto close = FourBar(links).margins(one(1e-6 - 0.4363));
  EXPECT_NEAR(margin_of(close, "crank_dead_centre")->value, 1e-6, 1e-14);
}

// Oracle: Freudenstein; the crank turns against the rocker (an antiparallelogram's ratio is that of
// its rolling ellipses, here below zero).
TEST(FourBar, ThatIsCrossedStaysCrossed) {
  FourBarGeometry links = parallelogram();
  links.branch = -1;
  const FourBar crossed(links);
  EXPECT_FALSE(crossed.constant_jacobian());
  for (double q = -2.97; q < 3; q += 0.1) {
    const auto at = crossed.transfer(one(q), one(0));
    ASSERT_TRUE(at) << q;
    EXPECT_NEAR(freudenstein(links, at->actuator_position_rad[0], q), 0, 1e-12);
    EXPECT_LT(at->jacobian(0, 0), 0);
  }
}

// Oracle: power in is power out; the rotor's inertia is felt with the ratio's square.
TEST(FourBar, LosesNoPower) {
  const FourBar four_bar(crank_rocker());
  const auto at = four_bar.transfer(one(2), one(3));
  ASSERT_TRUE(at);
  const SmallVector torque = actuator_torque_Nm(*at, one(10));
  EXPECT_NEAR(torque[0] * at->jacobian(0, 0) * 3, 10 * 3, 1e-13);
  const double J = at->jacobian(0, 0);
  EXPECT_NEAR(reflected_inertia_kg_m2(*at, one(0.4))(0, 0), 0.4 * J * J, 1e-15);
}

// Oracle: the inverse. The rocker's position comes back from the crank's.
TEST(FourBar, ComesBackFromItsCrank) {
  const FourBar four_bar(crank_rocker());
  for (double q = 1.75; q < 2.5; q += 0.05) {
    const auto at = four_bar.transfer(one(q), one(0));
    ASSERT_TRUE(at);
    const auto back = test::joint_position_rad(four_bar, at->actuator_position_rad, one(2.1));
    ASSERT_TRUE(back) << q;
    EXPECT_NEAR((*back)[0], q, 1e-11);
  }
}

TEST(FourBar, RefusesLengthsThatCannotClose) {
  FourBarGeometry links = crank_rocker();
  EXPECT_FALSE(four_bar_objection(links));
  links.ground_m = 6.499;
  EXPECT_FALSE(four_bar_objection(links));
  links.ground_m = 6.5;
  ASSERT_TRUE(four_bar_objection(links));
  EXPECT_NE(four_bar_objection(links)->find("ground of 6.5 m"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::hopper
