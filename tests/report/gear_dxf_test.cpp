// SPDX-License-Identifier: Apache-2.0
// The DXF file as another reader sees it. Oracles: dxflib's reader, and the involute by its
// equation.
#include "src/report/workshop/gear_dxf.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace torquewright::report {
namespace {

using gearbox::Point;

constexpr double kPi = std::numbers::pi;

/// What a reader finds, by layer.
class Reader : public DL_CreationAdapter {
 public:
  void addPolyline(const DL_PolylineData& data) override {
    is_closed[attributes.getLayer()] = (data.flags & 1) != 0;
  }
  void addVertex(const DL_VertexData& data) override {
    points[attributes.getLayer()].push_back({data.x, data.y});
  }
  void addCircle(const DL_CircleData& data) override {
    circles[attributes.getLayer()].push_back(data.radius);
  }
  void addText(const DL_TextData& data) override { texts += data.text + "\n"; }

  std::map<std::string, std::vector<Point>> points;
  std::map<std::string, bool> is_closed;
  std::map<std::string, std::vector<double>> circles;
  std::string texts;
};

TEST(GearDxf, HoldsEveryOutlineToAMicrometre) {
  DrawnGearbox drawn{.name = "knee",
                     .topology = "3k",
                     .teeth = {44, 44, 32, 132, 120},
                     .planet_count = 4,
                     .module_mm = 0.6,
                     .ratio = "20",
                     .hollow_shaft_diameter_mm = 12.0,
                     .ring_wall_mm = {}};
  const DrawingLayout layout = lay_out(drawn);
  const std::string text = gear_dxf(layout, gear_data(layout, {10.0, 9.0}));
  std::stringstream stream(text);
  Reader reader;
  DL_Dxf dxf;
  ASSERT_TRUE(dxf.in(stream, &reader));
  ASSERT_EQ(reader.points.size(), 5U);
  const std::vector<Point> middles = dxf_middles(layout);
  for (std::size_t i = 0; i < layout.gears.size(); ++i) {
    const DrawnGear& gear = layout.gears[i];
    std::string layer = gear.id;
    for (char& letter : layer) letter = static_cast<char>(std::toupper(letter));
    const std::vector<Point>& points = reader.points[layer];
    EXPECT_TRUE(reader.is_closed[layer]);
    ASSERT_GT(points.size(), static_cast<std::size_t>(20 * gear.teeth)) << layer;
    EXPECT_EQ(points.size() % static_cast<std::size_t>(gear.teeth), 0U);
    const double m = gear.module_mm, z = static_cast<double>(gear.teeth);
    const double base_mm = 0.5 * m * z * std::cos(kPi / 9.0);
    const double half_rad = kPi / (2.0 * z) + std::tan(kPi / 9.0) - kPi / 9.0;
    const double tip_mm = m * gear.tip_radius, root_mm = m * gear.root_radius;
    int on_flank = 0;
    double least_mm = 1e300, most_mm = 0.0;
    for (const Point& point : points) {
      const double x = point.x - middles[i].x, y = point.y - middles[i].y;
      const double radius_mm = std::hypot(x, y);
      least_mm = std::min(least_mm, radius_mm);
      most_mm = std::max(most_mm, radius_mm);
      // Flanks: well away from tip and root.
      const double low_mm = std::min(tip_mm, root_mm), high_mm = std::max(tip_mm, root_mm);
      if (radius_mm < low_mm + 0.6 * m || radius_mm > high_mm - 0.6 * m) continue;
      const double angle = std::atan2(y, x) * z / (2.0 * kPi);
      const double off_rad = std::abs(angle - std::round(angle)) * 2.0 * kPi / z;
      const double profile_rad = std::acos(base_mm / radius_mm);
      EXPECT_NEAR(radius_mm * (off_rad - (half_rad - std::tan(profile_rad) + profile_rad)), 0.0,
                  1e-6)
          << layer;
      ++on_flank;
    }
    EXPECT_GT(on_flank, 4 * gear.teeth) << layer;
    EXPECT_NEAR(std::min(tip_mm, root_mm), least_mm, 1e-6) << layer;
    EXPECT_NEAR(std::max(tip_mm, root_mm), most_mm, 1e-6) << layer;
  }
  EXPECT_EQ(reader.circles["PITCH"].size(), 5U);
  EXPECT_NE(reader.texts.find("span over 5 teeth"), std::string::npos) << reader.texts;
  EXPECT_NE(reader.texts.find("face width: 9.0000 mm"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::report
