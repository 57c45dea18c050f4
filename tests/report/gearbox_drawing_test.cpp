// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/gearbox_drawing.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "gearbox/train/cut_train.hpp"
#include "tests/gearbox/teeth/mesh_oracle.hpp"

namespace torquewright::report {
namespace {

using gearbox::PlacedGear;
using gearbox::Point;

DrawnGearbox d151() {
  return {.name = "knee",
          .topology = "3k",
          .teeth = {44, 44, 32, 132, 120},
          .planet_count = 4,
          .module_mm = 0.6,
          .ratio = "20",
          .hollow_shaft_diameter_mm = 12.0,
          .ring_wall_mm = {}};
}

DrawnGearbox planetary() {
  return {.name = "single stage",
          .topology = "planetary",
          .teeth = {45, 30, 105},
          .planet_count = 3,
          .module_mm = 1.0,
          .ratio = "10/3",
          .hollow_shaft_diameter_mm = 30.0,
          .ring_wall_mm = {}};
}

// What stands between `before` and the next `after`, searched from `from`; npos-safe.
std::string between(const std::string& text, const std::string& before, const std::string& after,
                    std::size_t from = 0) {
  const std::size_t start = text.find(before, from);
  if (start == std::string::npos) return "";
  const std::size_t begin = start + before.size();
  return text.substr(begin, text.find(after, begin) - begin);
}

// Empty if every element is closed in order, else the first offender.
std::string first_unbalanced_element(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::string element = svg.substr(at + 1, svg.find('>', at) - at - 1);
    if (element.front() == '?' || element.back() == '/') continue;
    const bool is_end = element.front() == '/';
    const std::string name = element.substr(is_end ? 1 : 0, element.find(' '));
    if (!is_end) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return name;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

// One placed copy of a shape.
struct Use {
  Point place;
  double turn_deg = 0.0;
};

std::vector<Use> uses_of(const std::string& svg, const std::string& id) {
  std::vector<Use> uses;
  const std::string start = "href=\"#" + id + "\" transform=\"translate(";
  for (std::size_t at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    std::istringstream numbers(between(svg, "translate(", ")", at) + " " +
                               between(svg, "rotate(", ")", at));
    Use& use = uses.emplace_back();
    numbers >> use.place.x >> use.place.y >> use.turn_deg;
  }
  return uses;
}

// Points of a path of relative cubic curves, 16 on each.
std::vector<Point> path_points(const std::string& svg, const std::string& id) {
  std::string data = between(svg, "<path id=\"" + id + "\" d=\"M", "Z");
  for (char& character : data) character = character == 'c' ? ' ' : character;
  std::istringstream numbers(data);
  Point pen;
  numbers >> pen.x >> pen.y;
  std::vector<Point> points;
  Point a, b, c;
  while (numbers >> a.x >> a.y >> b.x >> b.y >> c.x >> c.y) {
    for (int i = 0; i < 16; ++i) {
      const double t = i / 16.0;
      const double s = 1.0 - t;
      const double wa = 3.0 * s * s * t, wb = 3.0 * s * t * t, wc = t * t * t;
      points.push_back(
          {pen.x + wa * a.x + wb * b.x + wc * c.x, pen.y + wa * a.y + wb * b.y + wc * c.y});
    }
    pen = {pen.x + c.x, pen.y + c.y};
  }
  return points;
}

// Oracle: the document itself, read back: every planet's path, where it is placed, against the
// involutes of the gears where those are placed. Curves within 3e-7 module, coordinates rounded to
// 1e-6 mm at 1.2 (1.5) mm per module on paper: together below 2e-6 module.
void expect_planets_mesh_in(const std::string& svg, double paper_mm_per_module,
                            const std::string& planet_id, const std::string& mate_id,
                            const gearbox::ToothForm& mate, std::size_t mate_use) {
  const Use placed = uses_of(svg, mate_id).at(mate_use);
  // Paper's y runs downwards; the shapes are symmetric, so that a mirrored turn is all it takes.
  const PlacedGear gear{mate, {}, -placed.turn_deg * std::numbers::pi / 180.0};
  const std::vector<Point> shape = path_points(svg, planet_id);
  ASSERT_GT(shape.size(), 1000u);
  for (const Use& use : uses_of(svg, planet_id)) {
    std::vector<Point> points;
    for (const Point& corner : shape) {
      const Point point =
          gearbox::turned({corner.x, -corner.y}, -use.turn_deg * std::numbers::pi / 180.0);
      points.push_back({(use.place.x - placed.place.x + point.x) / paper_mm_per_module,
                        (placed.place.y - use.place.y + point.y) / paper_mm_per_module});
    }
    const gearbox::Contact contact = gearbox::measure_points(points, gear);
    EXPECT_LE(contact.deepest(), 2e-6) << planet_id << " in " << mate_id;
    EXPECT_GE(contact.loosest(), -1e-3) << planet_id << " in " << mate_id;
  }
}

TEST(GearboxDrawing, SaysWhatCannotExist) {
  DrawnGearbox drawing = d151();
  EXPECT_EQ(gearbox_drawing(drawing).find("cannot exist"), std::string::npos);
  drawing.cannot_exist = {"neighbour_clearance.layer_1"};
  EXPECT_NE(gearbox_drawing(drawing).find("cannot exist: neighbour_clearance.layer_1<"),
            std::string::npos);
}

TEST(GearboxDrawing, GearsMeshInTheDocument) {
  const std::string svg = gearbox_drawing(d151());
  ASSERT_NE(svg.find("scale 2:1"), std::string::npos);
  ASSERT_EQ(uses_of(svg, "planet_1").size(), 4u);
  ASSERT_EQ(uses_of(svg, "planet_2").size(), 4u);
  const gearbox::ToothForm fixed_ring = gearbox::internal_gear(132);
  const gearbox::ToothForm output_ring = gearbox::internal_gear(120);
  expect_planets_mesh_in(svg, 1.2, "planet_1", "sun", gearbox::external_gear(44), 0);
  expect_planets_mesh_in(svg, 1.2, "planet_1", "fixed_ring", fixed_ring, 0);
  expect_planets_mesh_in(svg, 1.2, "planet_2", "output_ring", output_ring, 0);
}

TEST(GearboxDrawing, PlanetaryGearsMeshInTheDocument) {
  const std::string svg = gearbox_drawing(planetary());
  ASSERT_NE(svg.find("scale 1.5:1"), std::string::npos);
  expect_planets_mesh_in(svg, 1.5, "planet_1", "sun", gearbox::external_gear(45), 0);
  expect_planets_mesh_in(svg, 1.5, "planet_1", "fixed_ring", gearbox::internal_gear(105), 0);
}

// Matsuki's drive of two modules: the same oracle, in the modules of each layer, scale 2:1.
TEST(GearboxDrawing, ShiftedGearsOfTwoModulesMeshInTheDocument) {
  gearbox::GearTrain train{"3k", {12, 39, 32, 90, 81}, {.476, .762, .536, 0, 0}, 3, 0.8, {}};
  train.layer_2_module_mm = 0.8467;
  train.shifts = *gearbox::coaxial_shifts(train);
  DrawnGearbox drawing = d151();
  drawing.teeth = train.teeth;
  drawing.planet_count = 3;
  drawing.module_mm = train.module_mm;
  drawing.profile_shift = train.shifts;
  drawing.layer_2_module_mm = train.layer_2_module_mm;
  const std::string svg = gearbox_drawing(drawing);
  ASSERT_NE(svg.find("scale 2:1"), std::string::npos);
  gearbox::ToothForm sun = gearbox::external_gear(12, .476);
  sun.tip_radius = 0.5 * gearbox::cut_train(train)->gears[0].tip_diameter;
  expect_planets_mesh_in(svg, 1.6, "planet_1", "sun", sun, 0);
  expect_planets_mesh_in(svg, 1.6, "planet_1", "fixed_ring",
                         gearbox::internal_gear(90, train.shifts[3]), 0);
  expect_planets_mesh_in(svg, 2 * .8467, "planet_2", "output_ring",
                         gearbox::internal_gear(81, train.shifts[4]), 0);
  EXPECT_EQ(first_unbalanced_element(svg), "");
  drawing.profile_shift[4] += .01;
  EXPECT_NE(gearbox_drawing(drawing).find("With these profile shifts the gears have no common"),
            std::string::npos);
}

TEST(GearboxDrawing, IsBalancedAndSmallAndTheSameAgain) {
  for (const DrawnGearbox& drawing : {d151(), planetary()}) {
    const std::string svg = gearbox_drawing(drawing);
    EXPECT_EQ(first_unbalanced_element(svg), "");
    EXPECT_LT(svg.size(), 1'000'000u);
    EXPECT_EQ(svg, gearbox_drawing(drawing));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
  }
}

TEST(GearboxDrawing, StatesWhatItShows) {
  const std::string svg = gearbox_drawing(d151());
  for (const char* text :
       {">knee<", ">F: 132 teeth<", ">O: 120 teeth<", ">S: 44<", "ratio 20 ", "module 0.6 mm",
        ">planets: 4, all alike, equally spaced<", ">a = 26.4<", "pitch \xC3\x98 79.20",
        "blank \xC3\x98 83.40", "\xC3\x98 12.00", "\xCE\xB1 = 30.00\xC2\xB0", ">20 mm<"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
}

/// Rectangles of a class: x, y, width, height.
std::vector<std::array<double, 4>> rectangles(const std::string& svg, const std::string& style) {
  std::vector<std::array<double, 4>> found;
  const std::string start = "<rect class=\"" + style + "\"";
  for (std::size_t at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    found.push_back({std::stod(between(svg, "x=\"", "\"", at)),
                     std::stod(between(svg, "y=\"", "\"", at)),
                     std::stod(between(svg, "width=\"", "\"", at)),
                     std::stod(between(svg, "height=\"", "\"", at))});
  }
  return found;
}

// Oracle: by hand at scale 2:1, S of 44 teeth of 0.6 mm: root at 26.4 - 2 * 1.25 * 0.6 = 24.9 mm,
// bore 12 mm; P1 at 26.4 mm from the axis. (The legend has a rectangle of each gear too.)
TEST(GearboxDrawing, CutsAlongTheAxisToScale) {
  DrawnGearbox drawing = d151();
  drawing.face_width_mm = {8.0, 6.5};
  const std::string svg = gearbox_drawing(drawing);
  ASSERT_NE(svg.find("scale 2:1 (A4 x 3)"), std::string::npos);
  const auto sun = rectangles(svg, "sun"), planet = rectangles(svg, "planet_2");
  ASSERT_EQ(sun.size(), 3u);
  ASSERT_EQ(planet.size(), 3u);                             // four planets: one faces the first
  EXPECT_NEAR(sun[0][2], 16.0, 1e-3);                       // 2 * 8 mm
  EXPECT_NEAR(sun[0][3], 0.5 * (24.9 - 12.0) * 2.0, 1e-3);  // from bore to root
  EXPECT_NEAR(planet[0][2], 13.0, 1e-3);                    // 2 * 6.5 mm
  EXPECT_NEAR(planet[0][0], sun[0][0] + 16.0 + 1.2, 1e-3);  // a module between the layers
  const double axis_y = sun[0][1] + sun[0][3] + 12.0;       // the bore's radius below
  EXPECT_NEAR(planet[0][1] + 0.5 * planet[0][3], axis_y - 2.0 * 26.4, 1e-3);
  for (const char* words : {">b1 = 8<", ">b2 = 6.5<",
                            ">Dashed: 0.6 mm between the layers are "
                            "assumed.<",
                            ">Not known and not drawn: carrier, pins, bearings.<"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(svg.find("(assumed)"), std::string::npos);
}

TEST(GearboxDrawing, SaysThatWidthsAreAssumed) {
  for (const DrawnGearbox& drawing : {d151(), planetary()}) {
    const std::string svg = gearbox_drawing(drawing);
    EXPECT_NE(svg.find(">Face widths are not stated: ten modules are assumed.<"),
              std::string::npos);
    EXPECT_NE(svg.find(" (assumed)<"), std::string::npos);
  }
  EXPECT_NE(gearbox_drawing(d151()).find(">b1 = 6 (assumed)<"), std::string::npos);
  EXPECT_NE(gearbox_drawing(planetary()).find("(A3), lengths in mm"), std::string::npos);
  DrawnGearbox wrong = d151();
  wrong.face_width_mm = {8.0, 0.0};
  EXPECT_THROW((void)gearbox_drawing(wrong), std::invalid_argument);
}

TEST(GearboxDrawing, NamesTheClockingOfDifferentPlanets) {
  DrawnGearbox drawing = d151();
  drawing.teeth = {44, 42, 31, 128, 117};
  const std::string svg = gearbox_drawing(drawing);
  EXPECT_NE(svg.find("2 part numbers"), std::string::npos);
  // A half of 360 gcd(42, 31) / (42 * 31) degrees: -0.138248...
  EXPECT_NE(svg.find("part 1 0\xC2\xB0, part 2 -0.13825\xC2\xB0"), std::string::npos);
}

TEST(GearboxDrawing, SaysWhatDoesNotFit) {
  DrawnGearbox drawing = d151();
  drawing.teeth = {43, 44, 32, 131, 119};
  EXPECT_NE(gearbox_drawing(drawing).find("Equal spacing does not mesh"), std::string::npos);
  drawing.teeth = {12, 39, 20, 90, 54};
  EXPECT_NE(gearbox_drawing(drawing).find("no common centre distance"), std::string::npos);
  drawing.teeth = {3, 5, 2, 13, 10};
  EXPECT_NE(gearbox_drawing(drawing).find("drawn as circles"), std::string::npos);
}

TEST(GearboxDrawing, EscapesNames) {
  DrawnGearbox drawing = d151();
  drawing.name = "<a & \"b\">\x01\xEF\xBF\xBF";
  const std::string svg = gearbox_drawing(drawing);
  EXPECT_NE(svg.find(">&lt;a &amp; &quot;b&quot;&gt;  <"), std::string::npos);
  EXPECT_EQ(first_unbalanced_element(svg), "");
}

TEST(GearboxDrawing, RefusesWhatIsNoGearbox) {
  const auto refused = [](auto change) {
    DrawnGearbox drawing = d151();
    change(drawing);
    EXPECT_THROW((void)gearbox_drawing(drawing), std::invalid_argument);
  };
  refused([](DrawnGearbox& drawing) { drawing.topology = "cycloid"; });
  refused([](DrawnGearbox& drawing) { drawing.teeth.pop_back(); });
  refused([](DrawnGearbox& drawing) { drawing.teeth[2] = 0; });
  refused([](DrawnGearbox& drawing) { drawing.planet_count = 0; });
  refused([](DrawnGearbox& drawing) { drawing.module_mm = 0.0; });
  refused([](DrawnGearbox& drawing) { drawing.module_mm = std::nan(""); });
  refused([](DrawnGearbox& drawing) { drawing.ring_wall_mm = -1.0; });
  refused([](DrawnGearbox& drawing) { drawing.layer_2_module_mm = 0.0; });
  refused([](DrawnGearbox& drawing) { drawing.profile_shift = {0.1, 0.2}; });
  refused([](DrawnGearbox& drawing) { drawing.profile_shift = {std::nan(""), 0, 0, 0, 0}; });
  refused([](DrawnGearbox& drawing) { drawing.profile_shift = {-2, -2, 0, 0, 0}; });
  refused([](DrawnGearbox& drawing) {
    drawing.hollow_shaft_diameter_mm = std::numeric_limits<double>::infinity();
  });
}

}  // namespace
}  // namespace torquewright::report
