// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/root_form.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearbox/teeth/shaper.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kAngle_rad = kPressureAngle_rad;
constexpr double kRound = 1e-12;

ShaperAtDepth unshifted(double shaper, double ring) {
  return *shaper_at_depth({ring, 0.0, ring / 2.0 + 1.25, shaper});
}

double largest(double shaper, double planet, double ring) {
  return *largest_shaper_tip_radius(unshifted(shaper, ring),
                                    {planet, 0.0, ring, ring / 2.0 - 1.0, (ring - planet) / 2.0},
                                    planet / 2.0 + 1.0);
}

// Oracle: a rack's addendum of 1 needs a straight depth of 1, and more teeth come ever closer.
TEST(RootForm, DepthsApproachThatOfARack) {
  EXPECT_NEAR(depth_reached_by_gear(1e7), 1.0, 1e-6);
  EXPECT_NEAR(depth_reached_by_ring(1e7), 1.0, 1e-6);
  for (double teeth = 35; teeth < 400; teeth += 1) {
    EXPECT_LT(depth_reached_by_gear(teeth - 1), depth_reached_by_gear(teeth));
    EXPECT_GT(depth_reached_by_ring(teeth - 1), depth_reached_by_ring(teeth));
  }
}

// Oracle: equation (8), which says the same of a planet by coordinates of its own.
TEST(RootForm, LargestHobIsThatOfEquationEight) {
  for (const auto& [planet, ring] : {std::pair{44.0, 132.0}, {32.0, 120.0}, {63.0, 147.0}}) {
    const double a = (ring - planet) / 2.0;
    EXPECT_NEAR(largest_hob_tip_radius_for(1.25, depth_reached_by_ring(ring)),
                *largest_hob_tip_radius({planet, 0.0, ring, ring / 2.0 - 1.0, a}), kRound);
  }
}

// docs/derivations/tooth_outline.md, "Which cutters never fail": what the search does not ask.
TEST(RootForm, OfAssumedCuttersNeverFails) {
  // The hob of ISO 53 profile A between external gears, up to all teeth that a document admits.
  EXPECT_LT(depth_reached_by_gear(200000.0), straight_depth_of_hob(1.25, 0.38));
  EXPECT_GT(depth_reached_by_gear(250000.0), straight_depth_of_hob(1.25, 0.38));
  // A planet's hob in rings that go with gears that are not undercut: S, P1, P2 >= 18.
  EXPECT_GT(largest_hob_tip_radius_for(1.25, depth_reached_by_ring(54.0)), 0.05);
  // A shaper of as many teeth as the planet; 0.25/(1 - sin(alpha)) = 0.37995 is the limit.
  double before = 1.0;
  for (double planet = 10; planet < 1e6; planet = std::ceil(planet * 1.07)) {
    const double radius = largest(planet, planet, 3.0 * planet);
    EXPECT_LT(radius, before);
    EXPECT_GT(radius, 0.25 / (1.0 - std::sin(kAngle_rad)));
    before = radius;
  }
  // And two external gears of 17 teeth and more: a standard pair passes with that hob.
  for (double teeth = 17; teeth < 500; teeth += 1) {
    EXPECT_GT(largest_hob_tip_radius_for(1.25, depth_reached_by_gear(teeth)), 0.38);
  }
}

// Oracle: the condition in its other form, path left by the shaper against path reached.
TEST(RootForm, LargestShaperIsWhereThePathsMeet) {
  for (const auto& [shaper, planet] : {std::pair{20.0, 44.0}, {25.0, 32.0}, {40.0, 63.0}}) {
    const double radius = largest(shaper, planet, 150.0);
    EXPECT_NEAR(path_left_by_shaper(shaper, 1.25, radius), path_reached_by_planet(planet), kRound);
  }
  EXPECT_LT(largest(12.0, 44.0, 132.0), 0.0);
}

TEST(RootForm, UndercutOfTheReferenceHob) {
  EXPECT_NEAR(undercut_limit_teeth(1.0), kUndercutLimit_teeth, kRound);
  EXPECT_NEAR(undercut_limit_teeth(straight_depth_of_hob(1.25, 0.0)), 21.37158,
              1e-5);  // 2.5/sin^2(20)
}

// The shaper's tooth, drawn on a circle: half its angle at the centres of two roundings that touch
// is what one of them takes, seen from the axis.
TEST(Shaper, FullRoundingLeavesNoLand) {
  for (const double teeth : {12.0, 20.0, 40.0, 100.0}) {
    const ShaperAtDepth shaper = unshifted(teeth, 200.0);
    const double radius = full_shaper_rounding(shaper);
    // The point of the flank at which the rounding begins lies on the circle about the centre.
    const double centre = shaper.tip_radius - radius;
    const double string = std::sqrt(centre * centre - square(shaper.base_radius)) + radius;
    const double start = std::hypot(shaper.base_radius, string);
    const double half_rad = std::numbers::pi / (2.0 * teeth) + kReferenceInvolute -
                            involute(std::acos(shaper.base_radius / start));
    EXPECT_NEAR(std::hypot(start * std::cos(half_rad) - centre, start * std::sin(half_rad)), radius,
                1e-9)
        << teeth;
  }
}

}  // namespace
}  // namespace torquewright::gearbox
