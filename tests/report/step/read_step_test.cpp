// SPDX-License-Identifier: Apache-2.0
// The STEP file as another program sees it. Oracles: Open CASCADE's reader, its check of solids and
// its volumes; the shoelace formula over the exact outline; lines drawn through both of two gears.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/report/workshop/gear_step.hpp"
#include "tests/report/step/read_solids.hpp"
#include "tests/report/step/step_gearboxes.hpp"

namespace torquewright::report {
namespace {

using gearbox::Point;
using test::ReadSolid;

struct Written {
  DrawingLayout layout;
  GearBodies bodies;
  std::vector<ReadSolid> read;

  Written(const DrawnGearbox& gearbox, const BodySizes& sizes)
      : layout(lay_out(gearbox)),
        bodies(gear_bodies(layout, sizes)),
        read(test::read_solids(gear_step(bodies))) {}

  std::size_t find(const std::string& name) const {
    for (std::size_t i = 0; i < bodies.placed.size(); ++i) {
      if (bodies.placed[i].name == name) return i;
    }
    ADD_FAILURE() << name;
    return 0;
  }
};

const Written& compound() {
  static const Written written(test::compound(), test::kCompoundSizes);
  return written;
}

void expect_exact_solids(const Written& gearbox) {
  ASSERT_EQ(gearbox.read.size(), gearbox.bodies.placed.size());
  for (std::size_t i = 0; i < gearbox.read.size(); ++i) {
    const ReadSolid& solid = gearbox.read[i];
    const PlacedBody& placed = gearbox.bodies.placed[i];
    const GearBody& body = gearbox.bodies.bodies[placed.body];
    const DrawnGear& gear = gearbox.layout.gears[placed.body];
    EXPECT_TRUE(solid.is_valid) << placed.name;
    const double exact_mm3 = test::exact_volume_mm3(gear, body);
    // Deviation times length of the outline times width, at most.
    const double allowed_mm3 =
        kPieceDeviation_mm * 6.0 * gear.module_mm * static_cast<double>(gear.teeth) * body.width_mm;
    EXPECT_NEAR(solid.volume_mm3, exact_mm3, allowed_mm3) << placed.name;
    const double reach_mm = gear.internal ? 0.5 * blank_diameter_mm(gearbox.layout, gear)
                                          : gear.module_mm * gear.tip_radius;
    // A tooth need not point along an axis: half a pitch beside it the reach is so much less.
    const double less_mm =
        gear.internal
            ? 0.0
            : reach_mm * (1.0 - std::cos(std::numbers::pi / static_cast<double>(gear.teeth)));
    EXPECT_LE(solid.box_mm[3], placed.middle.x + reach_mm + 1e-5) << placed.name;
    EXPECT_GE(solid.box_mm[3], placed.middle.x + reach_mm - less_mm - 1e-5) << placed.name;
    EXPECT_LE(-solid.box_mm[1], -placed.middle.y + reach_mm + 1e-5) << placed.name;
    EXPECT_NEAR(solid.box_mm[2], placed.from_mm, 1e-6) << placed.name;
    EXPECT_NEAR(solid.box_mm[5], placed.from_mm + body.width_mm, 1e-6) << placed.name;
  }
}

TEST(ReadStep, CompoundHasTheExactVolumes) { expect_exact_solids(compound()); }

/// Where a horizontal line crosses a closed boundary.
void add_crossings(const std::vector<Point>& boundary, double y, std::vector<double>& crossings) {
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Point &from = boundary[i], &to = boundary[(i + 1) % boundary.size()];
    if ((from.y > y) == (to.y > y)) continue;
    crossings.push_back(from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x));
  }
}

/// What both solids cover of a line, from their crossings: between odd and even ones.
double common_mm(std::vector<double> first, std::vector<double> second) {
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  double sum_mm = 0.0;
  for (std::size_t i = 0; i + 1 < first.size(); i += 2) {
    for (std::size_t j = 0; j + 1 < second.size(); j += 2) {
      sum_mm +=
          std::max(0.0, std::min(first[i + 1], second[j + 1]) - std::max(first[i], second[j]));
    }
  }
  return sum_mm;
}

std::vector<double> crossings_of(const ReadSolid& solid, double y) {
  std::vector<double> crossings;
  for (const std::vector<Point>& boundary : solid.bottom) add_crossings(boundary, y, crossings);
  return crossings;
}

/// Area that both solids cover, by lines across the first.
double common_area_mm2(const ReadSolid& first, const ReadSolid& second) {
  constexpr int kLines = 1000;
  const double step_mm = (first.box_mm[4] - first.box_mm[1]) / kLines;
  double sum_mm = 0.0;
  for (int line = 0; line < kLines; ++line) {
    const double y = first.box_mm[1] + (line + 0.5) * step_mm;
    sum_mm += common_mm(crossings_of(first, y), crossings_of(second, y));
  }
  return sum_mm * step_mm;
}

/// The same solid turned about a point.
ReadSolid turned_about(const ReadSolid& solid, const Point& middle, double angle_rad) {
  ReadSolid turned = solid;
  for (std::vector<Point>& boundary : turned.bottom) {
    for (Point& point : boundary) {
      const Point moved = gearbox::turned({point.x - middle.x, point.y - middle.y}, angle_rad);
      point = {middle.x + moved.x, middle.y + moved.y};
    }
  }
  return turned;
}

/// Gears without backlash touch; what the two share is chords and the deviation of the curves, at
/// most twice that along all of two teeth. A planet that stands 1/100 of a pitch beside its place
/// cuts into the flanks of its mate by that on one side.
void expect_no_overlap(const Written& gearbox, const std::string& planet, const std::string& mate) {
  const std::size_t place = gearbox.find(planet);
  const ReadSolid& first = gearbox.read[place];
  const ReadSolid& second = gearbox.read[gearbox.find(mate)];
  const DrawnGear& gear = gearbox.layout.gears[gearbox.bodies.placed[place].body];
  const double allowed_mm2 = 2.0 * kPieceDeviation_mm * 2.0 * 6.0 * gear.module_mm;
  EXPECT_LT(common_area_mm2(first, second), allowed_mm2) << planet << " and " << mate;
  const double turn_rad = 0.02 * std::numbers::pi / static_cast<double>(gear.teeth);
  const ReadSolid beside = turned_about(first, gearbox.bodies.placed[place].middle, turn_rad);
  EXPECT_GT(common_area_mm2(beside, second), 4.0 * allowed_mm2) << planet << " and " << mate;
}

TEST(ReadStep, MeshingGearsOfTheCompoundDoNotOverlap) {
  for (const char* planet : {"planet_1 1 of 3", "planet_1 2 of 3"}) {
    expect_no_overlap(compound(), planet, "sun");
    expect_no_overlap(compound(), planet, "fixed_ring");
  }
  expect_no_overlap(compound(), "planet_2 2 of 3", "output_ring");
}

}  // namespace
}  // namespace torquewright::report
