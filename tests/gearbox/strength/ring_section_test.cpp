// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/ring_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/strength/tooth_load.hpp"
#include "gearbox/teeth/tooth_outline.hpp"
#include "tests/gearbox/strength/example_strength.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kAlpha_rad = std::numbers::pi / 9.0;

ToothForm shaped(std::int64_t ring, std::int64_t shaper, double rounding, double addendum = 1.25,
                 double shift = 0.0) {
  ToothForm form = internal_gear(ring, shift, addendum);
  form.shaper_teeth = shaper;
  form.fillet_radius = rounding;
  return form;
}

/// Radius of the circle through three points.
double circle_radius(const Point& a, const Point& b, const Point& c) {
  const double ab = std::hypot(b.x - a.x, b.y - a.y), bc = std::hypot(c.x - b.x, c.y - b.y);
  const double ca = std::hypot(a.x - c.x, a.y - c.y);
  return ab * bc * ca / std::abs(2.0 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

/// The worst section as the drawing shows the tooth: every point of the fillet is tried, its notch
/// is the circle through it and its neighbours, and the tip's force is the normal of the drawn
/// flank.
struct Worst {
  double stress = 0.0;  ///< Y_F Y_S
  double chord = 0.0;
  double at_60_degrees = 0.0;  ///< Where the fillet's tangent stands so to the tooth's middle.
};

Worst worst_section(const ToothForm& form) {
  const std::vector<OutlineCurve> curves = half_pitch_curves(form);
  const double half_pitch_rad = std::numbers::pi / static_cast<double>(form.teeth);
  // The tooth's middle on the x axis, its lower flank drawn.
  const auto seen = [&](const OutlineCurve& curve, double t) {
    return turned(curve.point(t), -half_pitch_rad);
  };
  const OutlineCurve& flank = curves.at(2);
  const Point tip = seen(flank, flank.to);
  const Point before = seen(flank, flank.to + 1e-6 * (flank.from - flank.to));
  // Into the tooth, whose flank lies below its middle: along the normal.
  const double length = std::hypot(before.x - tip.x, before.y - tip.y);
  const double normal_x = -(before.y - tip.y) / length, normal_y = (before.x - tip.x) / length;
  const double cosine = std::abs(normal_y);
  const double crossing = tip.x - tip.y * normal_x / normal_y;
  const OutlineCurve& fillet = curves.at(1);
  Worst worst;
  double least_error = 1.0;
  constexpr int kPoints = 20000;
  const double step = (fillet.to - fillet.from) / kPoints;
  for (int i = 1; i < kPoints; ++i) {
    const double t = fillet.from + step * i;
    const Point point = seen(fillet, t);
    const Point left = seen(fillet, t - 1e-3 * (fillet.to - fillet.from));
    const Point right = seen(fillet, t + 1e-3 * (fillet.to - fillet.from));
    const double h = point.x - crossing, s = 2.0 * std::abs(point.y);
    const double q = s / (2.0 * circle_radius(left, point, right));
    const double y_f = 6.0 * h * cosine / (s * s * std::cos(kAlpha_rad));
    const double y_s = (1.2 + 0.13 * s / h) * std::pow(q, 1.0 / (1.21 + 2.3 * h / s));
    if (y_f * y_s > worst.stress) worst = {y_f * y_s, s, worst.at_60_degrees};
    const double tangent_rad = std::atan2(std::abs(right.y - left.y), std::abs(right.x - left.x));
    if (std::abs(tangent_rad - std::numbers::pi / 3.0) < least_error) {
      least_error = std::abs(tangent_rad - std::numbers::pi / 3.0);
      worst.at_60_degrees = y_f * y_s;
    }
  }
  return worst;
}

// Oracle: a search over the drawn outline. The circle through points 1e-3 of the fillet apart is
// its curvature to some 1e-6; the greatest value is flat where it lies.
TEST(RingSection, IsTheWorstOfTheDrawnFillet) {
  for (const ToothForm& form :
       {shaped(147, 63, 0.3), shaped(132, 44, 0.3), shaped(132, 20, 0.2), shaped(64, 25, 0.25),
        shaped(120, 30, 0.1, 1.4), shaped(90, 30, 0.15, 1.1), shaped(90, 30, 0.3, 1.25, 0.4)}) {
    const auto section = critical_ring_section(form);
    ASSERT_TRUE(section.has_value());
    const Worst worst = worst_section(form);
    EXPECT_NEAR(section->factors.form * section->factors.concentration / worst.stress, 1.0, 1e-5)
        << form.teeth << " by " << form.shaper_teeth;
    EXPECT_NEAR(section->chord / worst.chord, 1.0, 1e-2);
    // A tangent of 60 degrees, which ISO 6336-3 is remembered to take, asks for no more.
    EXPECT_LE(worst.at_60_degrees, worst.stress * (1.0 + 1e-9));
    EXPECT_GT(worst.at_60_degrees, worst.stress * 0.8);
  }
}

// Oracle: the same search, and (4), (5) by hand: the ankle's ring of 147 teeth by the assumed
// shaper of 63 teeth, rounded by 0.3, at 21 Nm: F 1111.1 N, b m 6 mm^2, K_gamma K_Fbeta 1.1 1.2.
TEST(RingSection, IsWhatAStrengthTakes) {
  const StrengthCase strength = test::d110a_strength();
  for (const ToothLoad& load : tooth_loads(strength, 21)) {
    if (load.gear != "ring") continue;
    ASSERT_NEAR(load.cutter_tip_radius, 0.3, 1e-12);
    const double overlap = loaded_train(strength.train).meshes.at(1).contact_ratio;
    const double factors = worst_section(shaped(147, 63, 0.3)).stress * (0.25 + 0.75 / overlap);
    const double expected_MPa = 21 / (3 * 6.3e-3) / 6.0 * factors * 1.1 * 1.2;
    EXPECT_NEAR(load.root.stress_MPa / expected_MPa, 1.0, 1e-5);
  }
}

// Oracle: the same search for the stated cutter.
TEST(RingSection, FollowsTheCutter) {
  StrengthCase strength = test::d110a_strength();
  const auto ring_MPa = [&](const Cutters& cutters) {
    strength.train.cutters = cutters;
    const auto loads = tooth_loads(strength, 21);
    const auto ring = std::find_if(loads.begin(), loads.end(),
                                   [](const ToothLoad& load) { return load.gear == "ring"; });
    return ring->root.stress_MPa;
  };
  const double standard_MPa = ring_MPa({.shaper_tip_radius = 0.2});
  const double standard = worst_section(shaped(147, 63, 0.2)).stress;
  EXPECT_NEAR(ring_MPa({.shaper_tip_radius = 0.1}) / standard_MPa,
              worst_section(shaped(147, 63, 0.1)).stress / standard, 1e-5);
  EXPECT_NEAR(ring_MPa({.shaper_tip_radius = 0.2, .shaper_teeth = 30, .shaper_addendum = 1.4}) /
                  standard_MPa,
              worst_section(shaped(147, 30, 0.2, 1.4)).stress / standard, 1e-5);
}

TEST(RingSection, NeedsAShaper) {
  ToothForm form = internal_gear(132);
  EXPECT_FALSE(critical_ring_section(form).has_value());
}

}  // namespace
}  // namespace torquewright::gearbox
