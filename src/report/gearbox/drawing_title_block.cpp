// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "src/report/gearbox/drawing_sheet.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

constexpr double kBlockToRight_mm = 172.0;  // From its left edge to the sheet's right one.
constexpr double kBlockWidth_mm = 162.0;
constexpr double kBlockHeight_mm = 56.0;
constexpr std::size_t kMaxName = 56;  // Characters that find room in the title block.

// The name, cut after a whole character of UTF-8 if it is too long.
std::string short_name(const std::string& name) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool starts_character = (static_cast<unsigned char>(name[i]) & 0xC0) != 0x80;
    if (starts_character && ++characters > kMaxName) return name.substr(0, i) + "...";
  }
  return name;
}

std::string planets_line(const DrawingLayout& layout) {
  const std::int64_t types = layout.phase.planet_types;
  std::string line = fmt::format("planets: {}, {}", layout.drawing.planet_count,
                                 types == 1 ? "all alike" : fmt::format("{} part numbers", types));
  return line + (layout.phase.equally_spaced ? ", equally spaced" : ", not equally spaced");
}

// Where P2 stands against P1 in each kind of planet, in degrees.
std::string clocking_line(const DrawingLayout& layout) {
  constexpr std::size_t kMaxShown = 4;
  std::string line = "clocking of P2 against P1:";
  std::set<std::int64_t> shown;
  for (const gearbox::PlanetPhase& planet : layout.phase.planets) {
    if (!shown.insert(planet.part_number).second) continue;
    if (shown.size() > kMaxShown) return line + " ...";
    const std::string angle =
        decimal(planet.clocking_rad * 180.0 / std::numbers::pi, 5) + "\xC2\xB0";
    if (layout.phase.planet_types == 1) return line + " " + angle;
    line += fmt::format("{} part {} {}", shown.size() == 1 ? "" : ",", planet.part_number, angle);
  }
  return line;
}

std::string clearance_line(const DrawingLayout& layout) {
  return fmt::format("carrier clearance: {:.4f} rad ({:.2f}\xC2\xB0), half of \xCE\xB1",
                     layout.carrier_clearance_rad,
                     layout.carrier_clearance_rad * 180.0 / std::numbers::pi);
}

// A round length that is 20 to 50 mm long on paper.
double bar_length_mm(double scale) {
  double length_mm = std::pow(10.0, std::floor(std::log10(50.0 / scale)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * length_mm * scale <= 50.0) return factor * length_mm;
  }
  return length_mm;
}

std::string scale_bar(const DrawingLayout& layout, const Point& place) {
  const double length_mm = bar_length_mm(layout.scale);
  const double paper_mm = length_mm * layout.scale;
  return svg_rectangle("bar", place, {0.5 * paper_mm, 1.2}) +
         svg_rectangle("frame", place, {paper_mm, 1.2}) +
         svg_text("note middle", {place.x, place.y - 1.2}, "0") +
         svg_text("note middle", {place.x + paper_mm, place.y - 1.2},
                  decimal(length_mm, 9) + " mm");
}

std::string centre_text(const DrawingLayout& layout) {
  return fmt::format("centre distance {} mm", decimal(layout.center_distance_mm, 6));
}

/// Two modules leave no room for the centre distance beside them.
std::string module_line(const DrawingLayout& layout) {
  const std::string first = fmt::format("module {} mm", decimal(layout.drawing.module_mm, 6));
  const auto& second_mm = layout.drawing.layer_2_module_mm;
  return second_mm ? fmt::format("{} (layer 2: {} mm)", first, decimal(*second_mm, 6))
                   : fmt::format("{}, {}", first, centre_text(layout));
}

/// One wall for both rings, unless each is as thick as its own teeth are high.
std::string wall_line(const DrawingLayout& layout) {
  const auto wall = [&](const DrawnLayer& layer) {
    return layer.ring ? decimal(ring_wall_mm(layout, layout.gears[*layer.ring]), 6) : "";
  };
  const std::string last = wall(layout.layers.back());
  std::string first = wall(layout.layers.front());
  if (first.empty()) first = last;
  const std::string walls = first == last ? first : fmt::format("{} and {}", first, last);
  return fmt::format("ring wall behind the root {} mm{}", walls,
                     layout.drawing.layer_2_module_mm ? "; " + centre_text(layout) : "");
}

}  // namespace

std::string title_block(const DrawingLayout& layout) {
  const double block_x_mm = sheet_width_mm(layout) - kBlockToRight_mm;
  const double x_mm = block_x_mm + 3.0;
  double y_mm = kTableTop_mm;
  std::string svg = svg_rectangle("frame", {block_x_mm, y_mm}, {kBlockWidth_mm, kBlockHeight_mm});
  svg += svg_text("title", {x_mm, y_mm + 8.0}, short_name(layout.drawing.name));
  svg += svg_line("rule", {block_x_mm, y_mm + 12.0}, {block_x_mm + kBlockWidth_mm, y_mm + 12.0});
  std::vector<std::string> lines{
      fmt::format("{} gearbox, ratio {} (input over output)", layout.drawing.topology,
                  short_name(layout.drawing.ratio)),
      module_line(layout), planets_line(layout)};
  if (layout.layers.size() > 1) lines.push_back(clocking_line(layout));
  lines.push_back(clearance_line(layout));
  lines.push_back(wall_line(layout));
  y_mm += 12.0;
  for (const std::string& line : lines) svg += svg_text("note", {x_mm, y_mm += 6.0}, line);
  if (!layout.drawing.cannot_exist.empty()) {
    const std::string names = fmt::format("{}", fmt::join(layout.drawing.cannot_exist, ", "));
    svg += svg_text("strong", {x_mm, y_mm += 6.0}, "cannot exist: " + short_name(names));
  }
  const double right_mm = block_x_mm + kBlockWidth_mm - 66.0;
  svg += svg_text("strong", {right_mm, kTableTop_mm + 19.0},
                  fmt::format("scale {} ({}), lengths in mm", layout.scale_text,
                              layout.layers.size() == 1 ? "A3" : "A4 x 3"));
  svg += scale_bar(layout, {right_mm, kTableTop_mm + 28.0});
  return svg;
}

}  // namespace torquewright::report
