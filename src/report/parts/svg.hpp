// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::report {

using gearbox::Point;

/// Elements of a drawing as SVG text, one a line. Lengths in millimetres on paper, y downwards;
/// style classes are those of the sheet.

/// Writes a number with so many decimals at most; no trailing zeros, no negative zero.
std::string decimal(double value, int decimals = 3);

/// Text as XML character data. Characters that XML cannot hold become spaces.
std::string escaped(std::string_view text);

std::string svg_line(std::string_view style, const Point& from, const Point& to);
std::string svg_circle(std::string_view style, const Point& center, double radius_mm);
std::string svg_rectangle(std::string_view style, const Point& corner, const Point& size);

/// An arc between two directions (counter-clockwise seen on the sheet, less than half a turn).
std::string svg_arc(std::string_view style, const Point& center, double radius_mm, double from_rad,
                    double to_rad);

/// The style names size and anchor; turned by `turn_deg` about its place.
std::string svg_text(std::string_view style, const Point& place, std::string_view text,
                     double turn_deg = 0.0);

/// A filled arrowhead with its tip at `tip`, pointing in `direction_rad` (counter-clockwise seen).
std::string svg_arrowhead(const Point& tip, double direction_rad);

/// `center` moved by `radius_mm` in `direction_rad`, counter-clockwise seen on the sheet.
Point on_circle(const Point& center, double radius_mm, double direction_rad);

}  // namespace torquewright::report
