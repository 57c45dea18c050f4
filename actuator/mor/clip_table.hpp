// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "actuator/clip.hpp"
#include "actuator/mor/mor_table.hpp"

namespace torquewright::actuator {

/// The points of a table: ascending speeds and the bounds there.
struct ClipPoints {
  std::vector<double> speeds_rad_s;
  std::vector<double> least_Nm;
  std::vector<double> greatest_Nm;
};

/// The points of a table's rows where the region is not empty: beside a gap the nearest bounds that
/// exist are held or joined.
ClipPoints clip_points(const MorTable& table);

/// Draws both bounds in by so much, no further than to the middle between them: lines between the
/// points then stay inside the region where they are off by no more.
ClipPoints drawn_in(ClipPoints points, double by_Nm);

/// Owns what a torquewright_table points into: rows and the index over them.
class ClipTable {
 public:
  /// Requires points at two different speeds or more, ascending; throws std::invalid_argument.
  explicit ClipTable(const ClipPoints& points);
  explicit ClipTable(const MorTable& table) : ClipTable(clip_points(table)) {}

  /// Returns a view that holds as long as this object lives where it is.
  TableView view() const;

 private:
  std::vector<torquewright_row> rows_;
  std::vector<std::uint32_t> first_row_;
  Interval rest_;
  double cells_per_rad_s_ = 0.0;
};

}  // namespace torquewright::actuator
