// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace torquewright::sweep {

/// A quantity and the values that it is to have, ascending.
struct Axis {
  std::string name;
  std::vector<double> values;
};

/// Every combination of the axes' values is a point. Points are numbered with the last axis
/// running first.
struct Grid {
  std::vector<Axis> axes;  ///< One or two.

  std::size_t points() const;
  /// Returns the values of a point, one an axis.
  std::vector<double> values_at(std::size_t point) const;
  /// "knee_ratio=8" or "knee_ratio=8 voltage=48.5": the same for no other point.
  std::string name_of(std::size_t point) const;
};

inline constexpr std::size_t kMostPoints = 100000;

/// NAME=FROM:TO[:STEP] (steps of 1 unless stated, TO included where they meet it; the decimal
/// fractions as written, not their roundings summed up) or NAME=A,B,C. Throws io::SpecError.
Axis read_axis(const std::string& text);

/// One text an axis. Throws io::SpecError: not one or two, the same name twice, more points than
/// kMostPoints.
Grid read_grid(const std::vector<std::string>& texts);

}  // namespace torquewright::sweep
