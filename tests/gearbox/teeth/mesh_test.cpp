// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "gearbox/teeth/shifted_mesh.hpp"

namespace torquewright::gearbox {
namespace {

/// Oracle: 2 * integral |x|/k(x) dx. Between the points where a pair enters or leaves or the
/// sliding turns, the integrand is linear, so that the midpoint rule is exact; k is counted.
double integrated_loss(double approach, double recess) {
  std::vector<double> marks{-approach, recess, 0.0};
  for (int pitch = 1; pitch <= 3; ++pitch) {
    marks.push_back(-approach + pitch);
    marks.push_back(recess - pitch);
  }
  std::erase_if(marks, [&](double x) { return x < -approach || x > recess; });
  std::sort(marks.begin(), marks.end());
  double sum = 0.0;
  for (std::size_t piece = 1; piece < marks.size(); ++piece) {
    const double middle = (marks[piece - 1] + marks[piece]) / 2.0;
    int pairs = 0;
    for (int pitch = -5; pitch <= 5; ++pitch) {
      pairs += (middle + pitch >= -approach && middle + pitch <= recess) ? 1 : 0;
    }
    sum += (marks[piece] - marks[piece - 1]) * std::abs(middle) / std::max(pairs, 1);
  }
  return 2.0 * sum;
}

TEST(SlidingLossFactor, IsTheIntegralOverThePath) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> total(1.0, 3.0);
  std::uniform_real_distribution<double> end(-2.0, 4.0);
  for (int trial = 0; trial < 20000; ++trial) {
    const double recess = end(random);
    const double approach = total(random) - recess;
    EXPECT_NEAR(sliding_loss_factor<double>({approach, recess}), integrated_loss(approach, recess),
                1e-12 * 30);  // squares of up to 5, a dozen terms
  }
}

TEST(SlidingLossFactor, IsOhlendorfsFormBetweenZeroAndOne) {
  for (double approach = 0.5; approach <= 1.0; approach += 0.1) {
    for (double recess = 0.5; recess <= 1.0; recess += 0.1) {
      const double short_form = approach * approach + recess * recess - approach - recess + 1.0;
      EXPECT_NEAR(sliding_loss_factor<double>({approach, recess}), short_form, 1e-14);
    }
  }
}

CutPair without_shift(MeshKind kind, double teeth_1, double teeth_2) {
  const double sign = kind == MeshKind::kExternal ? 1.0 : -1.0;
  return {{kind, teeth_1, teeth_2}, kReferenceAngle_rad, teeth_1 + 2.0, teeth_2 + sign * 2.0};
}

TEST(ReferenceProfile, ConstantsAreThoseOfTwentyDegrees) {
  EXPECT_NEAR(kReferenceSine, std::sin(kReferenceAngle_rad), 1e-16);
  EXPECT_NEAR(kReferenceCosine, std::cos(kReferenceAngle_rad), 2e-16);
  EXPECT_NEAR(kReferenceTangent, std::tan(kReferenceAngle_rad), 1e-16);
  EXPECT_NEAR(kUndercutLimit_teeth, 17.097, 5e-4);
}

// Oracle: the formulas with profile shift, at x = 0.
TEST(ZeroShiftMesh, EqualsTheGeneralOneAtZeroShift) {
  for (double planet = 12; planet <= 80; planet += 1) {
    for (double other = 12; other <= 80; other += 3) {
      const auto path = external_path(planet, other);
      const auto general = contact_path(without_shift(MeshKind::kExternal, planet, other));
      ASSERT_TRUE(general);
      EXPECT_NEAR(path.approach, general->approach, 1e-11);  // tan(acos) loses three digits
      EXPECT_NEAR(path.recess, general->recess, 1e-11);
    }
    for (double ring = std::max(34.0, planet + 5); ring <= 200; ring += 7) {
      const CutPair cut = without_shift(MeshKind::kInternal, planet, ring);
      const auto path = internal_path(planet, ring);
      const auto general = contact_path(cut);
      ASSERT_TRUE(general);
      EXPECT_NEAR(path.approach, general->approach, 1e-11);
      EXPECT_NEAR(path.recess, general->recess, 1e-11);
      EXPECT_NEAR(involute_interference_margin(planet, ring), *involute_interference_margin(cut),
                  1e-12);
      EXPECT_NEAR(trochoid_interference_margin(planet, ring), *trochoid_interference_margin(cut),
                  1e-11);
    }
  }
}

// Oracle: the limit of eq. (1) for many teeth, 1/(pi sin alpha cos alpha) for both ends.
TEST(ZeroShiftMesh, PathsTendToTheSameLimitFromBothSides) {
  const double limit = 2.0 / (std::numbers::pi * std::sin(2.0 * kReferenceAngle_rad));
  EXPECT_NEAR(2.0 * limit, kSupremumOfExternalContactRatio, 1e-15);
  double external = 0.0, ring = HUGE_VAL;
  for (double teeth = 34; teeth < 1e6; teeth *= 2) {
    EXPECT_GT(external_path_end(teeth), external);
    EXPECT_LT(ring_path_end(teeth), ring);
    external = external_path_end(teeth);
    ring = ring_path_end(teeth);
    EXPECT_LT(external, limit);
    EXPECT_GT(ring, limit);
  }
  EXPECT_NEAR(external, limit, 1e-4);
  EXPECT_NEAR(ring, limit, 1e-4);
}

// Oracle: the involute that is left ends at the base circle, z tan(alpha)/(2 pi) from the pitch.
TEST(ZeroShiftMesh, PathInARingOfFewTeethEndsAtTheBaseCircle) {
  for (double teeth = 1; teeth <= 33; ++teeth) {
    EXPECT_NEAR(ring_path_end(teeth), teeth * kReferenceTangent / (2.0 * std::numbers::pi), 1e-14);
  }
}

TEST(Interference, SmallestRingsAreThoseOfTheClosedForm) {
  // Reference section 5: smallest zero-shift ring free of involute interference. The closed form
  // z2 >= (z1^2 sin^2 - 4)/(2 z1 sin^2 - 4) is the oracle, its published values the check of it.
  const std::vector<std::pair<int, int>> published{
      {18, 161}, {20, 64}, {24, 40}, {25, 38}, {30, 34}};
  for (const auto& [planet, ring] : published) {
    const double square_of_sine = kReferenceSine * kReferenceSine;
    const double least = (planet * planet * square_of_sine - 4) / (2 * planet * square_of_sine - 4);
    EXPECT_GE(ring, least) << planet;
    EXPECT_GE(involute_interference_margin<double>(planet, ring), 0.0) << planet;
    if (ring > 34) {  // at 30 the ring's base circle decides, not this margin
      EXPECT_LT(ring - 1, least) << planet;
      EXPECT_LT(involute_interference_margin<double>(planet, ring - 1), 0.0) << planet;
    }
  }
}

TEST(Interference, RuleOfThumbOfNineTeeth) {
  // Reference section 5: 30/39 +0.0019, 30/38 -0.0008 rad.
  EXPECT_NEAR(trochoid_interference_margin(30.0, 39.0), 0.0019, 5e-5);
  EXPECT_NEAR(trochoid_interference_margin(30.0, 38.0), -0.0008, 5e-5);
}

TEST(Interference, MarginsOfD151) {
  // Reference section 5: P1-F 0.195/0.0080/0.0196, P2-O 0.114/0.0089/0.0268; eps 1.922, 1.897.
  EXPECT_NEAR(involute_interference_margin(44.0, 132.0), 0.195, 5e-4);
  EXPECT_NEAR(trochoid_interference_margin(44.0, 132.0), 0.0080, 5e-5);
  EXPECT_NEAR(*trimming_margin(without_shift(MeshKind::kInternal, 44, 132)), 0.0196, 5e-5);
  EXPECT_NEAR(involute_interference_margin(32.0, 120.0), 0.114, 5e-4);
  EXPECT_NEAR(trochoid_interference_margin(32.0, 120.0), 0.0089, 5e-5);
  EXPECT_NEAR(*trimming_margin(without_shift(MeshKind::kInternal, 32, 120)), 0.0268, 5e-5);
  EXPECT_NEAR(contact_ratio(internal_path(44.0, 132.0)), 1.922, 5e-4);
  EXPECT_NEAR(contact_ratio(internal_path(32.0, 120.0)), 1.897, 5e-4);
  EXPECT_NEAR(internal_path(44.0, 132.0).approach, 1.056, 5e-4);
  EXPECT_NEAR(internal_path(32.0, 120.0).approach, 1.064, 5e-4);
}

}  // namespace
}  // namespace torquewright::gearbox
