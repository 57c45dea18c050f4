// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/drawing_sheet.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

constexpr double kLegendY_mm = 222.0;
constexpr double kTableX_mm = 10.0;
constexpr double kRow_mm = 6.0;
constexpr double kTableWidth_mm = 232.0;

constexpr std::string_view kStyle = R"(<style>
text{font-family:sans-serif;font-size:3.2px;fill:#1b2631;stroke:#ffffff;stroke-width:0.9px;paint-order:stroke;stroke-linejoin:round}
.heading{font-size:4.6px;font-weight:bold}
.title{font-size:5.6px;font-weight:bold}
.label{font-size:3.8px;font-weight:bold}
.strong{font-weight:bold}
.middle{text-anchor:middle}
.end{text-anchor:end}
.warning{fill:#a93226;font-weight:bold}
.paper{fill:#ffffff}
.frame{fill:none;stroke:#1b2631;stroke-width:0.5px}
.frame-thin{fill:none;stroke:#1b2631;stroke-width:0.13px}
.rule{stroke:#1b2631;stroke-width:0.2px}
.thin{fill:none;stroke:#34495e;stroke-width:0.13px}
.arrow{fill:#34495e}
.center{fill:none;stroke:#7b241c;stroke-width:0.13px;stroke-dasharray:4 0.8 0.6 0.8}
.hidden{fill:none;stroke:#1b2631;stroke-width:0.13px;stroke-dasharray:1.2 0.7}
.mark{fill:#1b2631}
.bore{fill:#ffffff;stroke:#1b2631;stroke-width:0.2px}
.sun{fill:#f5d58a}
.planet_1{fill:#a9cce3}
.planet_2{fill:#aed9bd}
.fixed_ring{fill:#ccd1d1}
.output_ring{fill:#e5c1b0}
.sun,.planet_1,.planet_2,.fixed_ring,.output_ring{stroke:#1b2631;stroke-width:0.1px;fill-rule:evenodd}
.bar{fill:#1b2631}
</style>
)";

struct Column {
  double right_mm;  // Numbers end here; the first two columns start at the previous one.
  std::string_view title;
};

constexpr std::array<Column, 9> kColumns{{{36.0, "gear"},
                                          {50.0, "symbol"},
                                          {66.0, "layer"},
                                          {86.0, "teeth"},
                                          {108.0, "number"},
                                          {138.0, "pitch \xC3\x98 mm"},
                                          {168.0, "tip \xC3\x98 mm"},
                                          {198.0, "root \xC3\x98 mm"},
                                          {230.0, "base \xC3\x98 mm"}}};

std::string table_row(double y_mm, const std::array<std::string, 9>& cells) {
  std::string svg;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_first = i == 0;
    const double x_mm = kTableX_mm + (is_first ? 2.0 : kColumns[i].right_mm);
    svg += svg_text(is_first ? "cell" : "cell end", {x_mm, y_mm + 4.2}, cells[i]);
  }
  return svg + svg_line("rule", {kTableX_mm, y_mm + kRow_mm},
                        {kTableX_mm + kTableWidth_mm, y_mm + kRow_mm});
}

std::array<std::string, 9> cells_of(const DrawingLayout& layout, const DrawnGear& gear) {
  const double module_mm = gear.module_mm;
  const double pitch_mm = module_mm * static_cast<double>(gear.teeth);
  const auto diameter = [&](double radius) {
    return fmt::format("{:.3f}", 2.0 * module_mm * radius);
  };
  const bool is_planet = gear.symbol.front() == 'P';
  return {gear.label,
          gear.symbol,
          gear.layer,
          std::to_string(gear.teeth),
          std::to_string(is_planet ? layout.drawing.planet_count : 1),
          fmt::format("{:.3f}", pitch_mm),
          diameter(gear.tip_radius),
          diameter(gear.root_radius),
          fmt::format("{:.3f}", pitch_mm * std::cos(gearbox::kPressureAngle_rad))};
}

/// How the teeth were cut; shifts need a line of their own.
std::vector<std::string> note_lines(const DrawingLayout& layout) {
  const std::string dedenda =
      fmt::format("addendum 1, dedendum {:g} (rings {:g}) module",
                  layout.drawing.cutters.hob_depth(), layout.drawing.cutters.shaper_depth());
  const std::string roots = "Roots as hobbed and shaped.";
  const std::string involute = "Involute 20\xC2\xB0, ";
  if (layout.drawing.profile_shift.empty()) {
    return {involute + "no profile shift, no backlash; " + dedenda + ". " + roots};
  }
  std::string shifts;
  for (const DrawnGear& gear : layout.gears) {
    shifts += fmt::format("{} {} {:.4g}", shifts.empty() ? "" : ",", gear.symbol, gear.shift);
  }
  return {fmt::format("{}profile shift{} module, no backlash.", involute, shifts),
          "S and P1 shortened for clearance; " + dedenda + ". " + roots};
}

std::string warnings(const DrawingLayout& layout, const Point& place) {
  std::vector<std::string_view> lines;
  if (!layout.is_coaxial) {
    lines.push_back(layout.is_shifted()
                        ? "With these profile shifts the gears have no common centre distance."
                        : "Without profile shift these gears have no common centre distance.");
  }
  if (!layout.phase.equally_spaced) {
    lines.push_back("Equal spacing does not mesh: planets stand at the nearest places that do.");
  }
  for (const DrawnGear& gear : layout.gears) {
    if (gear.form) continue;
    lines.push_back(
        layout.is_shifted()
            ? "Gears of fewer than 7 or more than 600 teeth, or pointed, are drawn as circles."
            : "Gears of fewer than 7 or more than 600 teeth are drawn as circles.");
    break;
  }
  std::string svg;
  Point line_place = place;
  for (const std::string_view line : lines) {
    svg += svg_text("warning", line_place, line);
    line_place.y += 4.6;
  }
  return svg;
}

}  // namespace

double sheet_width_mm(const DrawingLayout& layout) {
  return kColumnWidth_mm * static_cast<double>(layout.layers.size() + 1);
}

std::string sheet_opening(const DrawingLayout& layout) {
  const double width_mm = sheet_width_mm(layout);
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "
             "xmlns=\"http://www.w3.org/2000/svg\" "
             "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n",
             width_mm, kSheetHeight_mm) +
         std::string(kStyle) + svg_rectangle("paper", {0, 0}, {width_mm, kSheetHeight_mm}) +
         svg_rectangle("frame", {5, 5}, {width_mm - 10, kSheetHeight_mm - 10});
}

std::string legend(const DrawingLayout& layout) {
  std::string svg;
  double x_mm = kTableX_mm + 2.0;
  for (const DrawnGear& gear : layout.gears) {
    svg += svg_rectangle(gear.id, {x_mm, kLegendY_mm - 2.8}, {5.0, 3.4});
    svg += svg_text("note", {x_mm + 7.0, kLegendY_mm}, gear.label);
    x_mm += 32.0;
  }
  svg += svg_line("center", {x_mm, kLegendY_mm - 1.1}, {x_mm + 14.0, kLegendY_mm - 1.1});
  svg +=
      svg_text("note", {x_mm + 16.0, kLegendY_mm}, "centre lines, pitch circles, carrier circle");
  x_mm += 92.0;
  svg += svg_circle("mark", {x_mm, kLegendY_mm - 1.1}, 0.6);
  return svg + svg_text("note", {x_mm + 2.5, kLegendY_mm},
                        layout.layers.size() > 1
                            ? "teeth of P1 and P2 that lie together (with the clocking stated)"
                            : "first tooth of each planet");
}

std::string gear_table(const DrawingLayout& layout) {
  std::array<std::string, 9> titles;
  for (std::size_t i = 0; i < titles.size(); ++i) titles[i] = kColumns[i].title;
  double y_mm = kTableTop_mm;
  std::string svg = svg_line("rule", {kTableX_mm, y_mm}, {kTableX_mm + kTableWidth_mm, y_mm});
  svg += table_row(y_mm, titles);
  for (const DrawnGear& gear : layout.gears) {
    y_mm += kRow_mm;
    svg += table_row(y_mm, cells_of(layout, gear));
  }
  for (const std::string& line : note_lines(layout)) {
    svg += svg_text("note", {kTableX_mm + 2.0, y_mm + 11.5}, line);
    y_mm += 4.6;
  }
  return svg + warnings(layout, {kTableX_mm + 2.0, y_mm + 11.5});
}

}  // namespace torquewright::report
