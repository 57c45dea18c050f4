// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/involute_meshes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace torquewright::oracles {
namespace {

// Oracle: gearbox.md section 5, "Zero shift equivalent" of SDP/SI equation 5-3: the smallest ring
// that a planet can mesh with.
TEST(InvoluteMeshes, SmallestRingWithoutInvoluteInterference) {
  const std::vector<std::array<std::int64_t, 2>> pairs{
      {18, 161}, {20, 64}, {24, 40}, {25, 38}, {30, 34}};
  for (const auto& [planet, ring] : pairs) {
    EXPECT_GE(involute_margin(planet, ring), 0) << planet << '/' << ring;
    // At 33 teeth a ring's tip lies inside its base circle and the margin is not a number.
    EXPECT_FALSE(involute_margin(planet, ring - 1) >= 0) << planet << '/' << ring - 1;
  }
}

// Oracle: gearbox.md section 5, four printed decimals.
TEST(InvoluteMeshes, TrochoidRuleOfThumb) {
  EXPECT_NEAR(static_cast<double>(trochoid_margin_rad(30, 39)), 0.0019, 5e-5);
  EXPECT_NEAR(static_cast<double>(trochoid_margin_rad(30, 38)), -0.0008, 5e-5);
}

// Oracle: gearbox.md section 5, D151: margins P1-F 0.195/0.0080, P2-O 0.114/0.0089,
// eps 1.922/1.897.
TEST(InvoluteMeshes, PublishedActuator) {
  EXPECT_NEAR(static_cast<double>(involute_margin(44, 132)), 0.195, 5e-4);
  EXPECT_NEAR(static_cast<double>(involute_margin(32, 120)), 0.114, 5e-4);
  EXPECT_NEAR(static_cast<double>(trochoid_margin_rad(44, 132)), 0.0080, 5e-5);
  EXPECT_NEAR(static_cast<double>(trochoid_margin_rad(32, 120)), 0.0089, 5e-5);
  EXPECT_NEAR(static_cast<double>(internal_path(44, 132).ratio()), 1.922, 5e-4);
  EXPECT_NEAR(static_cast<double>(internal_path(32, 120).ratio()), 1.897, 5e-4);
}

// Oracle: gearbox.md section 6: epsilon_A of the two ring meshes is 1.056 and 1.064.
TEST(InvoluteMeshes, ApproachOfThePublishedActuatorExceedsOnePitch) {
  EXPECT_NEAR(static_cast<double>(internal_path(44, 132).approach), 1.056, 5e-4);
  EXPECT_NEAR(static_cast<double>(internal_path(32, 120).approach), 1.064, 5e-4);
}

// Oracle: GEARpie's report of the pair S30 (30/30): H_V = pi (1/z1 + 1/z2) Lambda = 0.1494
// (gearbox.md section 12).
TEST(InvoluteMeshes, OhlendorfLossFactorOfS30) {
  const long double curvature = 2 * std::numbers::pi_v<long double> / 30;
  EXPECT_NEAR(static_cast<double>(curvature * loss_factor(external_path(30, 30))), 0.1494, 5e-5);
  EXPECT_NEAR(static_cast<double>(1 - external_efficiency(30, 30, 0.1L)), 0.01494, 5e-6);
}

// The closed forms of gearbox.md section 6, valid for 1 <= eps < 2 and any sign of its parts.
long double closed_form(const ContactPath& path) {
  const auto a = [](long double x) { return x * std::fabs(x); };
  return (a(path.approach) + a(path.recess) + a(1 - path.approach) + a(1 - path.recess)) / 2;
}

TEST(InvoluteMeshes, LossFactorBelowTwoPairsIsTheClosedForm) {
  for (long double approach = -0.4L; approach < 2.4L; approach += 0.07L) {
    for (long double ratio = 1.001L; ratio < 2; ratio += 0.09L) {
      const ContactPath path{approach, ratio - approach};
      EXPECT_NEAR(static_cast<double>(loss_factor(path)), static_cast<double>(closed_form(path)),
                  1e-15 * 10);
    }
  }
}

// Oracle: the friction power summed over one base pitch of rotation. Pairs stand one pitch apart;
// at every phase each of the k pairs carries 1/k of the load and slides in proportion to |x|.
long double summed_over_one_pitch(const ContactPath& path) {
  constexpr int kSteps = 20000;
  long double sum = 0;
  for (int step = 0; step < kSteps; ++step) {
    int pairs = 0;
    long double sliding = 0;
    for (long double x = -path.approach + (step + 0.5L) / kSteps; x <= path.recess; ++x) {
      ++pairs;
      sliding += std::fabs(x);
    }
    sum += 2 * sliding / pairs;
  }
  return sum / kSteps;
}

TEST(InvoluteMeshes, LossFactorIsTheMeanOverOnePitch) {
  const std::vector<ContactPath> paths{{0.5L, 0.7L}, {1.056L, 0.866L}, {1.3L, 1.1L},
                                       {0.9L, 1.6L}, {1.9L, 1.7L},     {-0.2L, 1.5L}};
  // Midpoint rule with jumps of order 1 at the change of pairs: error of order 1/steps.
  for (const ContactPath& path : paths) {
    EXPECT_NEAR(static_cast<double>(loss_factor(path)),
                static_cast<double>(summed_over_one_pitch(path)), 2e-4);
  }
}

// Oracle: geometry. A rack and a gear of infinitely many teeth are the limit of both kinds of mesh,
// 2/(pi sin 2 alpha) base pitches for a path bounded by two addenda of one module.
TEST(InvoluteMeshes, HugeGearsTendToTheRack) {
  const long double reach = 1 / (std::numbers::pi_v<long double> * std::sin(pressure_angle_rad()) *
                                 std::cos(pressure_angle_rad()));
  const std::int64_t many = 100000000;
  EXPECT_NEAR(static_cast<double>(external_path(many, many).ratio() / (2 * reach)), 1, 1e-6);
  EXPECT_NEAR(static_cast<double>(internal_path(many, many * 2).ratio() / (2 * reach)), 1, 1e-6);
}

}  // namespace
}  // namespace torquewright::oracles
