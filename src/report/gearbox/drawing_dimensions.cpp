// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/drawing_dimensions.hpp"

#include <cmath>
#include <numbers>

namespace torquewright::report {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOvershoot_mm = 1.5;  // Of an extension line past its dimension line.
constexpr double kTextGap_mm = 1.2;    // Between a dimension line and its text.
constexpr double kArrowRoom_mm = 7.0;  // Shorter dimension lines take their arrows from outside.
constexpr double kTail_mm = 5.0;       // Of a dimension line beyond arrows from outside.
constexpr double kShelf_mm = 4.0;      // Of a leader under its text.

}  // namespace

std::string horizontal_dimension(double from_x, double to_x, double from_y, double y,
                                 std::string_view text) {
  std::string svg;
  for (const double x : {from_x, to_x}) {
    svg += svg_line("thin", {x, from_y}, {x, y + kOvershoot_mm});
  }
  svg += svg_line("thin", {from_x, y}, {to_x, y});
  svg += svg_arrowhead({from_x, y}, kPi);
  svg += svg_arrowhead({to_x, y}, 0.0);
  return svg + svg_text("note middle", {0.5 * (from_x + to_x), y - kTextGap_mm}, text);
}

std::string vertical_dimension(const Point& lower, const Point& upper, double x,
                               std::string_view text) {
  std::string svg;
  for (const Point& point : {lower, upper}) {
    svg += svg_line("thin", point, {x + kOvershoot_mm, point.y});
  }
  svg += svg_line("thin", {x, lower.y}, {x, upper.y});
  svg += svg_arrowhead({x, lower.y}, -0.5 * kPi);
  svg += svg_arrowhead({x, upper.y}, 0.5 * kPi);
  return svg + svg_text("note middle", {x - kTextGap_mm, 0.5 * (lower.y + upper.y)}, text, 90.0);
}

std::string angular_dimension(const Point& center, double inner_mm, double outer_mm,
                              double from_rad, double to_rad, std::string_view text) {
  const double arc_mm = outer_mm + 5.0;
  std::string svg;
  for (const double ray_rad : {from_rad, to_rad}) {
    svg += svg_line("thin", on_circle(center, inner_mm, ray_rad),
                    on_circle(center, arc_mm + kOvershoot_mm, ray_rad));
  }
  const bool from_outside = (to_rad - from_rad) * arc_mm < kArrowRoom_mm;
  const double tail_rad = from_outside ? kTail_mm / arc_mm : 0.0;
  svg += svg_arc("thin", center, arc_mm, from_rad - tail_rad, to_rad + tail_rad);
  // An arrow lies along a chord of the arc, so it is turned by half the angle it spans.
  const double lean_rad = 1.3 / arc_mm;
  const double outwards = from_outside ? -1.0 : 1.0;
  const double turn_rad = outwards * (0.5 * kPi - lean_rad);
  svg += svg_arrowhead(on_circle(center, arc_mm, from_rad), from_rad - turn_rad);
  svg += svg_arrowhead(on_circle(center, arc_mm, to_rad), to_rad + turn_rad);
  const double middle_rad = 0.5 * (from_rad + to_rad);
  const char* style = std::cos(middle_rad) < 0.0 ? "note end" : "note";
  return svg + svg_text(style, on_circle(center, arc_mm + 2.5, middle_rad), text);
}

std::string diameter_inside(const Point& center, double radius_mm, std::string_view text) {
  constexpr double kSlope_rad = kPi / 6.0;
  const Point right = on_circle(center, radius_mm, kSlope_rad);
  const Point left = on_circle(center, radius_mm, kSlope_rad + kPi);
  const Point place = on_circle(center, kTextGap_mm, kSlope_rad + 0.5 * kPi);
  return svg_line("thin", left, right) + svg_arrowhead(right, kSlope_rad) +
         svg_arrowhead(left, kSlope_rad + kPi) + svg_text("note middle", place, text, 30.0);
}

std::string leader(const Point& tip, const Point& elbow, std::string_view text) {
  const double side = elbow.x < tip.x ? -1.0 : 1.0;
  const Point shelf{elbow.x + side * kShelf_mm, elbow.y};
  const double direction_rad = std::atan2(elbow.y - tip.y, tip.x - elbow.x);
  return svg_line("thin", tip, elbow) + svg_line("thin", elbow, shelf) +
         svg_arrowhead(tip, direction_rad) +
         svg_text(side < 0.0 ? "note end" : "note", {shelf.x + side, shelf.y + 1.1}, text);
}

}  // namespace torquewright::report
