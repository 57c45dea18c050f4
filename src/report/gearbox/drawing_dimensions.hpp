// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "src/report/parts/svg.hpp"

namespace torquewright::report {

/// Dimension line at height `y` between two vertical extension lines that start at `from_y`.
std::string horizontal_dimension(double from_x, double to_x, double from_y, double y,
                                 std::string_view text);

/// Dimension line at `x` between the heights of two points, from which extension lines start.
std::string vertical_dimension(const Point& lower, const Point& upper, double x,
                               std::string_view text);

/// The angle between two rays from `center`, drawn from `inner_mm` to just outside `outer_mm`.
/// Counter-clockwise from `from_rad`; at most half a turn.
std::string angular_dimension(const Point& center, double inner_mm, double outer_mm,
                              double from_rad, double to_rad, std::string_view text);

/// A diameter drawn across its own circle.
std::string diameter_inside(const Point& center, double radius_mm, std::string_view text);

/// An arrow to `tip` from a text at `elbow`; the text runs away from the tip.
std::string leader(const Point& tip, const Point& elbow, std::string_view text);

}  // namespace torquewright::report
