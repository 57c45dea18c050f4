// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/gear_dxf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numbers>

#include "gearbox/teeth/tooth_outline.hpp"
#include "src/report/workshop/dxf_sheet.hpp"

namespace torquewright::report {
namespace {

using gearbox::Point;

constexpr double kChord_mm = 2e-4;
constexpr double kText_mm = 2.5;
constexpr const char* kPitchLayer = "PITCH";
constexpr const char* kDataLayer = "DATA";

std::string layer_name(const DrawnGear& gear) {
  std::string name = gear.id;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return name;
}

double outer_radius_mm(const DrawingLayout& layout, const DrawnGear& gear) {
  return gear.internal ? 0.5 * blank_diameter_mm(layout, gear) : gear.module_mm * gear.tip_radius;
}

/// All points of a gear's outline about the origin, in mm, the first not repeated.
std::vector<Point> outline_mm(const DrawnGear& gear) {
  std::vector<Point> pitch =
      gearbox::sample(gearbox::pitch_curves(*gear.form), kChord_mm / gear.module_mm);
  pitch.pop_back();  // The next pitch begins there.
  std::vector<Point> points;
  for (std::int64_t tooth = 0; tooth < gear.teeth; ++tooth) {
    const double angle_rad =
        2.0 * std::numbers::pi * static_cast<double>(tooth) / static_cast<double>(gear.teeth);
    for (const Point& point : pitch) {
      const Point turned = gearbox::turned(point, angle_rad);
      points.push_back({gear.module_mm * turned.x, gear.module_mm * turned.y});
    }
  }
  return points;
}

void draw_gear(const DrawingLayout& layout, const DrawnGear& gear, const Point& middle,
               DxfSheet& sheet) {
  const std::string layer = layer_name(gear);
  if (gear.form) {
    sheet.outline(layer, middle, outline_mm(gear));
  } else {
    sheet.circle(layer, middle, gear.module_mm * gear.tip_radius);
    sheet.circle(layer, middle, gear.module_mm * gear.root_radius);
  }
  sheet.point(layer, middle);
  if (gear.internal) sheet.circle(layer, middle, outer_radius_mm(layout, gear));
  if (gear.symbol == "S")
    sheet.circle(layer, middle, 0.5 * layout.drawing.hollow_shaft_diameter_mm);
  sheet.circle(kPitchLayer, middle, 0.5 * gear.module_mm * static_cast<double>(gear.teeth));
}

void write_data(const DrawnGear& gear, const GearData& data, const Point& top, DxfSheet& sheet) {
  constexpr double kLine_mm = 1.7 * kText_mm;
  Point place = top;
  const auto line = [&](const std::string& words) {
    sheet.text(kDataLayer, place, words);
    place.y -= kLine_mm;
  };
  line(fmt::format("{} ({})", data.gear, gear.symbol));
  for (const auto& [what, value] : data_lines(data)) line(fmt::format("{}: {}", what, value));
  if (!gear.form) line("outline: tip and root circles alone");
}

}  // namespace

std::vector<Point> dxf_middles(const DrawingLayout& layout) {
  constexpr double kGap_mm = 60.0;  // Room for the data.
  std::vector<Point> middles;
  double right_mm = 0.0;
  for (const DrawnGear& gear : layout.gears) {
    const double radius_mm = outer_radius_mm(layout, gear);
    middles.push_back({right_mm + radius_mm, 0.0});
    right_mm += 2.0 * radius_mm + kGap_mm;
  }
  return middles;
}

std::string gear_dxf(const DrawingLayout& layout, const std::vector<GearData>& data) {
  std::vector<std::string> layers;
  for (const DrawnGear& gear : layout.gears) layers.push_back(layer_name(gear));
  layers.emplace_back(kPitchLayer);
  layers.emplace_back(kDataLayer);
  DxfSheet sheet(layers, kText_mm);
  const std::vector<Point> middles = dxf_middles(layout);
  for (std::size_t i = 0; i < layout.gears.size(); ++i) {
    const DrawnGear& gear = layout.gears[i];
    const double radius_mm = outer_radius_mm(layout, gear);
    draw_gear(layout, gear, middles[i], sheet);
    write_data(gear, data[i], {middles[i].x - radius_mm, -radius_mm - 3.0 * kText_mm}, sheet);
  }
  return sheet.finished();
}

}  // namespace torquewright::report
