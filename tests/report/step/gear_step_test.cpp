// SPDX-License-Identifier: Apache-2.0
// The STEP file of a gearbox by its text alone. Oracles: the involute by its equation, the shoelace
// formula over the exact outline, Euler's formula for solids, a parser of its own.
#include "src/report/workshop/gear_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "src/report/workshop/step_file.hpp"
#include "tests/report/step/step_gearboxes.hpp"
#include "tests/report/step/step_text.hpp"

namespace torquewright::report {
namespace {

using gearbox::Point;
using test::of_kind;
using test::step_entities;
using test::StepEntity;

constexpr double kPi = std::numbers::pi;

/// Arcs are exact; of them only where they begin.
std::vector<Point> points_of(const OutlinePiece& piece, int count) {
  if (piece.is_arc()) return {piece.points.front()};
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(on_bezier(piece.points, static_cast<double>(i) / count));
  }
  return points;
}

/// Area of the region between an arc of a circle and its chord.
double segment_mm2(const OutlinePiece& piece) {
  const Point &from = piece.points.front(), &to = piece.points.back();
  const double angle_rad = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
  return 0.5 * piece.arc_radius_mm * piece.arc_radius_mm * (angle_rad - std::sin(angle_rad));
}

double area_mm2(const std::vector<OutlinePiece>& outline) {
  std::vector<Point> corners;
  double segments_mm2 = 0.0;
  for (const OutlinePiece& piece : outline) {
    const std::vector<Point> points = points_of(piece, 200);
    corners.insert(corners.end(), points.begin(), points.end());
    if (piece.is_arc()) segments_mm2 += segment_mm2(piece);
  }
  return test::shoelace_mm2(corners) + segments_mm2;
}

/// How far a point lies from an involute flank of a gear, by the flank's equation; nothing where
/// it lies outside of them.
std::optional<double> off_flank_mm(const DrawnGear& gear, const Point& point) {
  const double m = gear.module_mm, z = static_cast<double>(gear.teeth);
  // Between the tip and 0.2 modules beyond the pitch circle there is no fillet.
  const double tip_mm = m * gear.tip_radius, pitch_mm = 0.5 * m * z;
  const double radius_mm = std::hypot(point.x, point.y);
  const double low_mm = gear.internal ? tip_mm : pitch_mm - 0.2 * m;
  const double high_mm = gear.internal ? pitch_mm + 0.2 * m : tip_mm;
  const double base_mm = pitch_mm * std::cos(kPi / 9.0);
  if (radius_mm < std::max(low_mm, base_mm) || radius_mm > high_mm) return std::nullopt;
  const double half_rad = kPi / (2.0 * z) + 2.0 * gear.shift * std::tan(kPi / 9.0) / z +
                          std::tan(kPi / 9.0) - kPi / 9.0;
  const double turns = std::atan2(point.y, point.x) * z / (2.0 * kPi);
  const double off_rad = std::abs(turns - std::round(turns)) * 2.0 * kPi / z;
  const double profile_rad = std::acos(base_mm / radius_mm);
  return radius_mm * (off_rad - (half_rad - std::tan(profile_rad) + profile_rad));
}

TEST(OutlinePieces, FollowTheInvolute) {
  for (const DrawnGearbox& gearbox : {test::compound(), test::stage()}) {
    for (const DrawnGear& gear : lay_out(gearbox).gears) {
      int on_flank = 0;
      for (const OutlinePiece& piece : outline_pieces(*gear.form, gear.module_mm)) {
        for (const Point& point : points_of(piece, 37)) {
          const auto off_mm = off_flank_mm(gear, point);
          if (!off_mm) continue;
          ++on_flank;
          EXPECT_LT(std::abs(*off_mm), 1.01 * kPieceDeviation_mm) << gear.id;
        }
      }
      EXPECT_GT(on_flank, 10 * gear.teeth) << gear.id;
    }
  }
}

// Oracle: the area between two outlines is at most the deviation times the length.
TEST(OutlinePieces, EncloseTheExactArea) {
  for (const DrawnGearbox& gearbox : {test::compound(), test::stage()}) {
    for (const DrawnGear& gear : lay_out(gearbox).gears) {
      const std::vector<OutlinePiece> outline = outline_pieces(*gear.form, gear.module_mm);
      const double length_mm = 6.0 * gear.module_mm * static_cast<double>(gear.teeth);
      EXPECT_NEAR(area_mm2(outline), test::exact_area_mm2(gear), kPieceDeviation_mm * length_mm)
          << gear.id;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point &end = outline[i].points.back(),
                    &begin = outline[(i + 1) % outline.size()].points.front();
        EXPECT_LT(std::hypot(end.x - begin.x, end.y - begin.y), 1e-9) << gear.id << " " << i;
      }
      // Tip, root, two flanks and two fillets, or without a land, and with a curve in two halves.
      EXPECT_LE(outline.size(), static_cast<std::size_t>(10 * gear.teeth)) << gear.id;
    }
  }
}

std::string compound_step() {
  return gear_step(gear_bodies(lay_out(test::compound()), test::kCompoundSizes));
}

std::multiset<std::string> first_names(const std::map<int, StepEntity>& entities,
                                       const std::string& kind) {
  std::multiset<std::string> names;
  for (const int number : of_kind(entities, kind)) {
    names.insert(entities.at(number).strings().front());
  }
  return names;
}

TEST(GearStep, NamesEveryGearAndEveryPlace) {
  const std::map<int, StepEntity> entities = step_entities(compound_step());
  EXPECT_EQ(first_names(entities, "PRODUCT"),
            (std::multiset<std::string>{"small", "sun", "planet_1", "planet_2", "fixed_ring",
                                        "output_ring"}));
  EXPECT_EQ(first_names(entities, "NEXT_ASSEMBLY_USAGE_OCCURRENCE"),
            (std::multiset<std::string>{"sun", "fixed_ring", "output_ring", "planet_1 1 of 3",
                                        "planet_1 2 of 3", "planet_1 3 of 3", "planet_2 1 of 3",
                                        "planet_2 2 of 3", "planet_2 3 of 3"}));
  EXPECT_EQ(of_kind(entities, "MANIFOLD_SOLID_BREP").size(), 5U);
}

TEST(GearStep, IsInMillimetresAndHasNoDate) {
  const std::string text = compound_step();
  EXPECT_NE(text.find("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"), std::string::npos);
  EXPECT_NE(text.find("FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'))"),
            std::string::npos);
  EXPECT_NE(text.find("FILE_NAME('small','1970-01-01T00:00:00',"), std::string::npos);
  EXPECT_EQ(text, compound_step());
}

TEST(GearStep, RefersToNothingThatIsMissing) {
  const std::map<int, StepEntity> entities = step_entities(compound_step());
  for (const auto& [number, entity] : entities) {
    for (const int other : entity.references()) EXPECT_TRUE(entities.contains(other)) << number;
  }
}

// Every edge bounds two faces, once in each direction.
TEST(GearStep, ClosesEverySolid) {
  const std::map<int, StepEntity> entities = step_entities(compound_step());
  std::map<int, std::pair<int, int>> uses;  // By edge: forward, backward.
  for (const int number : of_kind(entities, "ORIENTED_EDGE")) {
    const StepEntity& entity = entities.at(number);
    auto& [forward, backward] = uses[entity.references().front()];
    ++(entity.content.ends_with(".T.") ? forward : backward);
  }
  EXPECT_EQ(uses.size(), of_kind(entities, "EDGE_CURVE").size());
  for (const auto& [edge, count] : uses) EXPECT_EQ(count, std::pair(1, 1)) << edge;
}

// Euler and Poincare: V - E + F - inner loops = 2 (solids - holes through them).
TEST(GearStep, HasAsManyHolesAsItsGears) {
  const std::map<int, StepEntity> entities = step_entities(compound_step());
  const auto count = [&](const char* kind) {
    return static_cast<int>(of_kind(entities, kind).size());
  };
  constexpr int kSolids = 5, kHoles = 4;  // Sun, one planet, two rings.
  EXPECT_EQ(
      count("VERTEX_POINT") - count("EDGE_CURVE") + count("ADVANCED_FACE") - count("FACE_BOUND"),
      2 * (kSolids - kHoles));
}

TEST(GearStep, WritesForeignNames) {
  EXPECT_EQ(step_string("d'\xC3\xA9t\\"), "'d''\\X4\\000000E9\\X0\\t\\\\'");
  EXPECT_EQ(step_string("\xF0\x9F\x94\xA9\xFF"), "'\\X4\\0001F529\\X0\\\\X4\\000000FF\\X0\\'");
}

TEST(GearStep, WritesNumbersWithTheirPoint) {
  EXPECT_EQ(step_length(3.0), "3.");
  EXPECT_EQ(step_length(-0.0), "0.");
  EXPECT_EQ(step_length(-1e-12), "0.");
  EXPECT_EQ(step_length(-0.25), "-0.25");
  EXPECT_EQ(step_number(1.0 / 3.0), "0.333333333333333");
}

TEST(GearBodies, RefuseWhatIsNoBody) {
  const auto words_of = [](const DrawnGearbox& gearbox, const BodySizes& sizes) -> std::string {
    try {
      gear_bodies(lay_out(gearbox), sizes);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  BodySizes sizes = test::kCompoundSizes;
  sizes.bore_mm[2] = 12.0;
  EXPECT_EQ(words_of(test::compound(), sizes),
            "planet_2: a bore of 12 mm leaves no rim in a root of 11.1 mm");
  DrawnGearbox large = test::stage();
  large.teeth = {300, 200, 700};
  EXPECT_EQ(words_of(large, {{5.0}, {0.0, 0.0, 0.0}}),
            "ring of 700 teeth and profile shift 0 has no outline: fewer than 7 teeth, more than "
            "600, or flanks that cross before the tip");
}

}  // namespace
}  // namespace torquewright::report
