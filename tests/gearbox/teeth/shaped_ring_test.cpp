// SPDX-License-Identifier: Apache-2.0
// Oracle of all tests here: the shaper itself, as an area rolled in small steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/root_fillet.hpp"
#include "gearbox/teeth/shaper.hpp"
#include "gearbox/teeth/shaper_feed.hpp"
#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;

struct Shaper {
  double teeth, tip_radius, rounding;
};

// Half the angle of the shaper's tooth at a radius; negative beyond its tip. The rounding is the
// circle that touches tip circle and involute: its centre is found on the involute's normal.
class ShaperTooth {
 public:
  explicit ShaperTooth(const Shaper& shaper) : shaper_(shaper) {
    base_ = shaper.teeth / 2.0 * std::cos(kHalfTurn_rad / 9.0);
    double low = base_, high = shaper.tip_radius;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (low + high);
      const Point centre = behind_flank(middle);
      (std::hypot(centre.x, centre.y) + shaper.rounding < shaper.tip_radius ? low : high) = middle;
    }
    start_ = low;
    centre_ = behind_flank(low);
  }

  double half_angle_rad(double radius) const {
    if (radius > shaper_.tip_radius || radius < base_) return -1.0;
    if (radius <= start_) return flank_rad(radius);
    const double distance = std::hypot(centre_.x, centre_.y);
    const double cosine =
        (radius * radius + distance * distance - shaper_.rounding * shaper_.rounding) /
        (2.0 * radius * distance);
    return std::atan2(centre_.y, centre_.x) + std::acos(std::min(1.0, cosine));
  }

 private:
  double flank_rad(double radius) const {
    const double angle = std::acos(std::min(1.0, base_ / radius));
    return kHalfTurn_rad / (2.0 * shaper_.teeth) + kReferenceInvolute - (std::tan(angle) - angle);
  }
  // The rounding's centre if it touches the flank at this radius: back along the string.
  Point behind_flank(double radius) const {
    const double angle = flank_rad(radius);
    const double profile = std::acos(std::min(1.0, base_ / radius));
    const double normal =
        angle + kHalfTurn_rad / 2.0 - profile;  // Direction of the flank's outward normal.
    return {radius * std::cos(angle) - shaper_.rounding * std::cos(normal),
            radius * std::sin(angle) - shaper_.rounding * std::sin(normal)};
  }

  Shaper shaper_;
  double base_ = 0.0, start_ = 0.0;
  Point centre_;
};

// How far the shaper's tooth, rolling in the ring, gets beyond a point of the ring's plane at most;
// the ring's space stands on the x axis. Along circles about the shaper's axis, in so many turns of
// the shaper, which is drawn out of the ring by a part of its depth.
struct Rolling {
  double most_rad = 0.0, step_rad = 0.0, withdrawn = 0.0;
};

double shaper_cut(const ToothForm& ring, const Point& point, const Rolling& rolling) {
  const auto teeth = static_cast<double>(ring.teeth);
  const auto cutter = static_cast<double>(ring.shaper_teeth);
  const ShaperAtDepth at = *shaper_at_depth({teeth, ring.profile_shift, ring.root_radius, cutter});
  const ShaperTooth tooth({cutter, ring.root_radius - at.center_distance, ring.fillet_radius});
  double deepest = -1.0;
  const double centre = at.center_distance - rolling.withdrawn;
  for (double turn_rad = -rolling.most_rad; turn_rad <= rolling.most_rad;
       turn_rad += rolling.step_rad) {
    const Point placed = turned(point, turn_rad * cutter / teeth);
    const Point seen = turned({placed.x - centre, placed.y}, -turn_rad);
    const double radius = std::hypot(seen.x, seen.y);
    const double half_rad = tooth.half_angle_rad(radius);
    if (half_rad < 0.0) continue;
    deepest = std::max(deepest, radius * (half_rad - std::abs(std::atan2(seen.y, seen.x))));
  }
  return deepest;
}

double shaper_cut(const ToothForm& ring, const Point& point) {
  const double per_length = 2.0 / static_cast<double>(ring.shaper_teeth);
  return shaper_cut(ring, point, {5.0 * per_length, 1e-4 * per_length, 0.0});
}

ToothForm shaped(std::int64_t ring, double shift, std::int64_t shaper, double rounding,
                 double addendum = 1.25) {
  ToothForm form = internal_gear(ring, shift, addendum);
  form.shaper_teeth = shaper;
  form.fillet_radius = rounding;
  return form;
}

// What the shaper leaves must be the outline: no point is cut beyond, and each is touched.
TEST(ShapedRing, IsWhatTheShaperLeaves) {
  for (const ToothForm& form :
       {shaped(132, 0.0, 44, 0.3), shaped(132, 0.0, 20, 0.2), shaped(64, 0.0, 25, 0.25),
        shaped(90, 0.4, 30, 0.3), shaped(60, -0.2, 30, 0.1), shaped(132, 0.0, 20, 0.1, 1.4),
        shaped(64, 0.0, 25, 0.25, 1.05)}) {
    const std::vector<OutlineCurve> curves = half_pitch_curves(form);
    for (const OutlineCurve& curve : {curves.at(1), curves.at(2)}) {  // Fillet and flank.
      for (int i = 1; i < 12; ++i) {
        const Point point = curve.point(curve.from + (curve.to - curve.from) * i / 12.0);
        EXPECT_NEAR(shaper_cut(form, point), 0.0, 2e-6)
            << form.teeth << " by " << form.shaper_teeth << ", radius "
            << std::hypot(point.x, point.y);
      }
    }
  }
}

// Eq. (12): the shaper with the largest rounding just touches the flank where the planet's tip
// does, and one that is rounded 0.05 more stays away.
TEST(ShapedRing, ShaperOfEquationTwelveReachesThePlanetsTip) {
  struct Case {
    std::int64_t planet, ring, shaper;
    double addendum = 1.25;
  };
  for (const Case& each : {Case{44, 132, 20}, Case{32, 120, 16}, Case{63, 147, 30},
                           Case{44, 132, 30, 1.2}, Case{32, 120, 16, 1.3}}) {
    const auto planet = static_cast<double>(each.planet), ring = static_cast<double>(each.ring);
    ToothForm form = shaped(each.ring, 0.0, each.shaper, 0.0, each.addendum);
    const auto at =
        shaper_at_depth({ring, 0.0, form.root_radius, static_cast<double>(each.shaper)});
    form.fillet_radius = *largest_shaper_tip_radius(
        *at, {planet, 0.0, ring, ring / 2.0 - 1.0, (ring - planet) / 2.0}, planet / 2.0 + 1.0);
    ASSERT_GT(form.fillet_radius, 0.05) << each.shaper;
    // The planet's tip circle meets the line of action; distance from the ring's axis.
    const double sine = std::sin(kHalfTurn_rad / 9.0), cosine = std::cos(kHalfTurn_rad / 9.0);
    const double along =
        std::sqrt(std::pow(planet / 2.0 + 1.0, 2) - std::pow(planet / 2.0 * cosine, 2)) -
        planet / 2.0 * sine;
    const double radius = std::hypot(ring / 2.0 + along * sine, along * cosine);
    const double angle_rad = half_angle_rad(form, radius);
    const Point point{radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
    EXPECT_NEAR(shaper_cut(form, point), 0.0, 2e-6) << each.planet << "/" << each.ring;
    form.fillet_radius += 0.05;
    EXPECT_LT(shaper_cut(form, point), -2e-5) << each.planet << "/" << each.ring;
  }
}

/// How deep the shaper gets into the flanks and the tip of the ring on its way in.
double deepest_on_the_way_in(const ToothForm& ring) {
  const std::vector<OutlineCurve> curves = half_pitch_curves(ring);
  double deepest = -1.0;
  for (const OutlineCurve& curve : {curves.at(2), curves.at(3)}) {  // Flank and tip.
    for (const double share : {0.0, 0.5, 1.0}) {
      const Point point = curve.point(curve.from + (curve.to - curve.from) * share);
      for (double withdrawn = 0.1; withdrawn < 2.2; withdrawn += 0.1) {
        deepest = std::max(deepest, shaper_cut(ring, point, {1.2, 2e-3, withdrawn}));
      }
    }
  }
  return deepest;
}

// Eqs. (17)...(21): the tips of the ring are cut away where the margin is negative, and rings of a
// tooth more or less than the limit's neighbours tell it from the 2e-4 that is missed between
// turns.
TEST(ShaperFeed, CutsAwayTheTipsWhereItsMarginIsNegative) {
  struct Case {
    std::int64_t shaper;
    double addendum, rounding;
  };
  int cut = 0, kept = 0;
  for (const Case& each : {Case{20, 1.25, 0.0}, Case{20, 1.25, 0.2}, Case{25, 1.4, 0.1},
                           Case{31, 1.1, 0.15}, Case{40, 1.25, 0.2}}) {
    const std::int64_t least = least_fed_ring(each.shaper, each.addendum, each.rounding);
    for (std::int64_t ring = std::max<std::int64_t>(34, least - 5); ring <= least + 4; ring += 2) {
      const ToothForm form = shaped(ring, 0.0, each.shaper, each.rounding, each.addendum);
      const auto q = static_cast<double>(each.shaper), z = static_cast<double>(ring);
      const double margin =
          *feed_margin_rad({q, q / 2.0 + each.addendum, each.rounding}, {z, 0.0, z / 2.0 - 1.0});
      EXPECT_EQ(margin >= 0.0, ring >= least);
      if (std::abs(margin) < 0.002) continue;
      const double deepest = deepest_on_the_way_in(form);
      EXPECT_EQ(deepest > 2e-4, margin < 0.0) << each.shaper << " in " << ring << ": " << deepest;
      ++(margin < 0.0 ? cut : kept);
    }
  }
  EXPECT_GE(cut, 8);
  EXPECT_GE(kept, 8);
}

// Oracle: the trimming of a planet, which SDP/SI's table 5-4 holds elsewhere: an unrounded tool
// with the planet's addendum of 1 is one.
TEST(ShaperFeed, OfAnUnroundedToolIsTheTrimmingOfAPlanet) {
  for (const std::int64_t planet : {20, 25, 31, 40}) {
    for (std::int64_t ring = planet + 12; ring < planet + 40; ++ring) {
      const auto p = static_cast<double>(planet), z = static_cast<double>(ring);
      const auto margin = feed_margin_rad({p, p / 2.0 + 1.0, 0.0}, {z, 0.0, z / 2.0 - 1.0});
      const auto trimming =
          trimming_margin({{MeshKind::kInternal, p, z}, kReferenceAngle_rad, p + 2.0, z - 2.0});
      if (z / 2.0 - 1.0 <= z / 2.0 * kReferenceCosine) continue;
      ASSERT_TRUE(margin && trimming);
      // Theirs is an angle of the shaper, ours of the ring.
      EXPECT_NEAR(*margin * z / p, *trimming, 1e-12) << planet << " in " << ring;
    }
  }
}

// Whoever is fed into a ring is fed into every larger one: the search asks for a least ring.
TEST(ShaperFeed, GrowsWithTheRing) {
  for (const std::int64_t shaper : {10, 14, 20, 33, 60, 200, 1000}) {
    for (const double addendum : {1.01, 1.25, 1.3}) {
      for (const double rounding : {0.0, 0.1}) {
        const auto q = static_cast<double>(shaper);
        const std::int64_t least = least_fed_ring(shaper, addendum, rounding);
        double before = 0.0;
        for (std::int64_t ring = least; ring < 40 * shaper; ring += 1 + ring / 50) {
          const auto z = static_cast<double>(ring);
          const auto margin =
              feed_margin_rad({q, q / 2.0 + addendum, rounding}, {z, 0.0, z / 2.0 - 1.0});
          ASSERT_TRUE(margin.has_value()) << shaper << " in " << ring;
          EXPECT_GE(*margin * z, before) << shaper << " in " << ring;
          before = *margin * z;
        }
      }
    }
  }
}

// Oracle: neighbouring curves share their end points, and the radius never turns back.
TEST(ShapedRing, IsConnectedAndMonotone) {
  for (const std::int64_t shaper : {12, 20, 33, 44}) {
    for (std::int64_t ring = 60; ring < 200; ring += 7) {
      const auto curves = half_pitch_curves(shaped(ring, 0.0, shaper, 0.3));
      for (std::size_t i = 0; i + 1 < curves.size(); ++i) {
        const Point end = curves[i].point(curves[i].to);
        const Point start = curves[i + 1].point(curves[i + 1].from);
        EXPECT_NEAR(std::hypot(end.x - start.x, end.y - start.y), 0.0, 1e-9) << ring << "/" << i;
      }
      const std::vector<Point> points = sample(curves, 1e-5);
      for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LE(std::hypot(points[i].x, points[i].y),
                  std::hypot(points[i - 1].x, points[i - 1].y) + 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::gearbox
