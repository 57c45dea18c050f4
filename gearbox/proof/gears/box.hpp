// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace torquewright::gearbox::proof {

/// The variables of a proof: sun, planet_1, difference = planet_1 - planet_2 (planetary: sun,
/// planet, and 0 in the third place).
using Point = std::array<std::int64_t, 3>;

/// All whole points between two corners, both included.
struct Box {
  Point lower{};
  Point upper{};

  bool is_empty() const;
  bool is_point() const { return lower == upper; }
  bool contains(const Point& point) const;

  /// Number of points, or more than `enough` where there are more than `enough`.
  std::int64_t size_up_to(std::int64_t enough) const;

  std::size_t widest_variable() const;
};

/// The two halves across the widest variable of a box of at least two points.
std::array<Box, 2> halves(const Box& box);

/// Calls `visit(point)` for every point until it returns false; false if it did.
template <typename Visit>
bool for_each_point(const Box& box, Visit visit) {
  for (std::int64_t sun = box.lower[0]; sun <= box.upper[0]; ++sun) {
    for (std::int64_t planet = box.lower[1]; planet <= box.upper[1]; ++planet) {
      for (std::int64_t difference = box.lower[2]; difference <= box.upper[2]; ++difference) {
        if (!visit(Point{sun, planet, difference})) return false;
      }
    }
  }
  return true;
}

}  // namespace torquewright::gearbox::proof
