// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/svg.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::report {
namespace {

constexpr double kArrowLength_mm = 2.6;
constexpr double kArrowHalfAngle_rad = 0.16;

// U+FFFE and U+FFFF in UTF-8, which XML excludes.
bool is_noncharacter(std::string_view text, std::size_t at) {
  const std::string_view three = text.substr(at, 3);
  return three == "\xEF\xBF\xBE" || three == "\xEF\xBF\xBF";
}

}  // namespace

std::string decimal(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char character = text[i];
    if (is_noncharacter(text, i)) {
      result += ' ';
      i += 2;
    } else if (character == '&') {
      result += "&amp;";
    } else if (character == '<') {
      result += "&lt;";
    } else if (character == '>') {
      result += "&gt;";
    } else if (character == '"') {
      result += "&quot;";
    } else {
      const bool is_control = static_cast<unsigned char>(character) < 0x20;
      result += is_control ? ' ' : character;
    }
  }
  return result;
}

std::string svg_line(std::string_view style, const Point& from, const Point& to) {
  return fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", style,
                     decimal(from.x), decimal(from.y), decimal(to.x), decimal(to.y));
}

std::string svg_circle(std::string_view style, const Point& center, double radius_mm) {
  return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", style,
                     decimal(center.x), decimal(center.y), decimal(radius_mm, 6));
}

std::string svg_rectangle(std::string_view style, const Point& corner, const Point& size) {
  return fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", style,
                     decimal(corner.x), decimal(corner.y), decimal(size.x), decimal(size.y));
}

std::string svg_arc(std::string_view style, const Point& center, double radius_mm, double from_rad,
                    double to_rad) {
  const Point from = on_circle(center, radius_mm, from_rad);
  const Point to = on_circle(center, radius_mm, to_rad);
  return fmt::format("<path class=\"{}\" d=\"M{} {}A{} {} 0 0 0 {} {}\"/>\n", style,
                     decimal(from.x), decimal(from.y), decimal(radius_mm), decimal(radius_mm),
                     decimal(to.x), decimal(to.y));
}

std::string svg_text(std::string_view style, const Point& place, std::string_view text,
                     double turn_deg) {
  std::string turn;
  if (turn_deg != 0.0) {
    turn = fmt::format(" transform=\"rotate({} {} {})\"", decimal(-turn_deg), decimal(place.x),
                       decimal(place.y));
  }
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\"{}>{}</text>\n", style, decimal(place.x),
                     decimal(place.y), turn, escaped(text));
}

std::string svg_arrowhead(const Point& tip, double direction_rad) {
  const Point left = on_circle(tip, -kArrowLength_mm, direction_rad + kArrowHalfAngle_rad);
  const Point right = on_circle(tip, -kArrowLength_mm, direction_rad - kArrowHalfAngle_rad);
  return fmt::format("<path class=\"arrow\" d=\"M{} {}L{} {}L{} {}Z\"/>\n", decimal(tip.x),
                     decimal(tip.y), decimal(left.x), decimal(left.y), decimal(right.x),
                     decimal(right.y));
}

Point on_circle(const Point& center, double radius_mm, double direction_rad) {
  return {center.x + radius_mm * std::cos(direction_rad),
          center.y - radius_mm * std::sin(direction_rad)};
}

}  // namespace torquewright::report
