// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/tooth_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gearbox/teeth/root_fillet.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kPi = std::numbers::pi;

// Half the width of a hob's tooth at a depth below its middle line; negative beyond its tip.
double hob_half_width(double addendum, double depth, double tip_radius) {
  const double tangent = std::tan(kPressureAngle_rad);
  const double sine = std::sin(kPressureAngle_rad);
  const double arc_start = addendum - tip_radius * (1.0 - sine);
  if (depth > addendum) return -1.0;
  if (depth <= arc_start) return 0.25 * kPi - depth * tangent;
  const double arc_center =
      0.25 * kPi - arc_start * tangent - tip_radius * std::cos(kPressureAngle_rad);
  const double below_center = depth - (addendum - tip_radius);
  return arc_center +
         std::sqrt(std::max(0.0, tip_radius * tip_radius - below_center * below_center));
}

// How far the hob's tooth, rolling over the gear, gets into a point of the gear at most.
double deepest_cut(const ToothForm& form, const Point& point) {
  const double pitch_radius = 0.5 * static_cast<double>(form.teeth);
  const double half_pitch_rad = kPi / static_cast<double>(form.teeth);
  // The hob's tooth stands in the space clockwise of the tooth on the x axis, which is turned up.
  const Point start = turned(point, 0.5 * kPi + half_pitch_rad);
  double deepest = -1.0;
  for (double roll = -6.0; roll <= 6.0; roll += 1e-4) {
    const Point rolled = turned(start, -roll / pitch_radius);
    const double depth = pitch_radius + form.profile_shift - rolled.y;
    const double addendum = pitch_radius + form.profile_shift - form.root_radius;
    const double width = hob_half_width(addendum, depth, form.fillet_radius);
    if (width < 0.0) continue;
    deepest = std::max(deepest, width - std::abs(rolled.x - roll));
  }
  return deepest;
}

// Oracle: the hob itself, as an area rolled in small steps. What it leaves must be the outline: no
// point is cut into, and each is touched. Step 1e-4 leaves out at most 1e-8 / (2 * 0.03 radius).
TEST(ToothOutline, IsWhatTheHobLeaves) {
  struct Case {
    std::int64_t teeth;
    double shift, addendum;
  };
  for (const auto& [teeth, shift, addendum] :
       {Case{9, 0.0, 1.25}, Case{12, 0.0, 1.25}, Case{12, 0.476, 1.25}, Case{18, 0.0, 1.25},
        Case{44, 0.0, 1.25}, Case{39, 0.762, 1.25}, Case{18, 0.0, 1.4}, Case{44, 0.0, 1.05},
        Case{39, 0.3, 1.4}}) {
    const ToothForm form = external_gear(teeth, shift, addendum);
    const std::vector<OutlineCurve> curves = half_pitch_curves(form);
    for (const OutlineCurve& curve : {curves.at(1), curves.at(2)}) {  // Flank and fillet.
      for (int i = 1; i < 12; ++i) {
        const Point point = curve.point(curve.from + (curve.to - curve.from) * i / 12.0);
        // Mirrored, so that the point's flank faces the hob's tooth.
        const double cut = deepest_cut(form, {point.x, -point.y});
        EXPECT_NEAR(cut, 0.0, 2e-6) << teeth << " teeth, radius " << std::hypot(point.x, point.y);
      }
    }
  }
}

// Where the ring's tip circle crosses the line of action, seen from the planet's axis: by
// coordinates, planet at the origin, ring's axis at -a, pitch point beyond the planet.
double lowest_contact_radius(std::int64_t planet, std::int64_t ring, double ring_shift, double a) {
  const double planet_base = 0.5 * static_cast<double>(planet) * std::cos(kPi / 9.0);
  const double pitch_x = a * static_cast<double>(planet) / static_cast<double>(ring - planet);
  const double working_rad = std::acos(planet_base / pitch_x);
  const Point tangent{planet_base * std::cos(working_rad), planet_base * std::sin(working_rad)};
  const double tip = 0.5 * static_cast<double>(ring) - 1.0 + ring_shift;
  double inside = 0.0,
         outside = 1.0;  // Shares of the way from the tangent point to the pitch point.
  const auto at = [&](double share) {
    return Point{tangent.x + share * (pitch_x - tangent.x), tangent.y * (1.0 - share)};
  };
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (inside + outside);
    const Point point = at(middle);
    (std::hypot(point.x + a, point.y) < tip ? inside : outside) = middle;
  }
  return std::hypot(at(inside).x, at(inside).y);
}

// Oracle of eq. (8): the rolled hob. It touches the planet's involute where the ring's tip does,
// and a hob rounded by 0.05 more stays away from that point by more than ten times the tolerance.
TEST(ToothOutline, HobOfEquationEightReachesTheRingsTip) {
  struct Case {
    std::int64_t planet, ring;
    double planet_shift, ring_shift;
    double hob_addendum = 1.25;
  };
  for (const Case& each :
       {Case{44, 132, 0.0, 0.0}, Case{32, 120, 0.0, 0.0}, Case{63, 147, 0.0, 0.0},
        Case{40, 64, 0.3, 0.3}, Case{39, 90, -0.1, -0.1}, Case{44, 132, 0.0, 0.0, 1.2},
        Case{25, 64, 0.0, 0.0, 1.4}}) {
    const double a = 0.5 * static_cast<double>(each.ring - each.planet);
    ToothForm form =
        external_gear_in_ring(each.planet, each.planet_shift,
                              internal_gear(each.ring, each.ring_shift), a, each.hob_addendum);
    ASSERT_GT(form.fillet_radius, 0.0);
    ASSERT_LT(form.fillet_radius, kHobTipRadius) << each.planet << "/" << each.ring;
    const double radius = lowest_contact_radius(each.planet, each.ring, each.ring_shift, a);
    const double angle_rad = half_angle_rad(form, radius);
    const Point point{radius * std::cos(angle_rad), -radius * std::sin(angle_rad)};
    EXPECT_NEAR(deepest_cut(form, point), 0.0, 2e-6) << each.planet << "/" << each.ring;
    form.fillet_radius += 0.05;
    EXPECT_LT(deepest_cut(form, point), -2e-5) << each.planet << "/" << each.ring;
  }
}

// Oracle: half a pitch on the pitch circle, for every gear without profile shift.
TEST(ToothOutline, IsHalfAPitchThickOnThePitchCircle) {
  for (std::int64_t teeth = 7; teeth < 200; ++teeth) {
    const double pitch_radius = 0.5 * static_cast<double>(teeth);
    EXPECT_NEAR(2.0 * pitch_radius * half_angle_rad(external_gear(teeth), pitch_radius), 0.5 * kPi,
                1e-12);
  }
}

// Oracle: neighbouring curves share their end points, and the radius never turns back.
TEST(ToothOutline, IsConnectedAndMonotone) {
  for (std::int64_t teeth = 7; teeth < 200; ++teeth) {
    for (const ToothForm& form : {external_gear(teeth), internal_gear(teeth)}) {
      const auto curves = half_pitch_curves(form);
      for (std::size_t i = 0; i + 1 < curves.size(); ++i) {
        const Point end = curves[i].point(curves[i].to);
        const Point start = curves[i + 1].point(curves[i + 1].from);
        EXPECT_NEAR(end.x, start.x, 1e-9) << teeth << (form.internal ? " ring" : " gear");
        EXPECT_NEAR(end.y, start.y, 1e-9) << teeth << (form.internal ? " ring" : " gear");
      }
      const std::vector<Point> points = sample(curves, 1e-5);
      for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LE(std::hypot(points[i].x, points[i].y),
                  std::hypot(points[i - 1].x, points[i - 1].y) + 1e-12);
        EXPECT_GE(points[i].y, -1e-12) << teeth;
      }
    }
  }
}

TEST(ToothOutline, RefusesWhatCannotBeCut) {
  EXPECT_THROW((void)external_gear(6), std::invalid_argument);
  EXPECT_THROW((void)internal_gear(6), std::invalid_argument);
  EXPECT_THROW((void)external_gear(20, NAN), std::invalid_argument);
  EXPECT_THROW((void)external_gear(8, 1.0), std::invalid_argument);  // Pointed.
}

}  // namespace
}  // namespace torquewright::gearbox
