// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/report/gearbox/drawing_layout.hpp"
#include "src/report/workshop/outline_pieces.hpp"

namespace torquewright::report {

/// A gear as a body between two planes, about its own axis; lengths in mm.
struct GearBody {
  std::string name;   ///< As in documents: sun, planet, ring, ...
  std::string shape;  ///< What it is drawn and coloured as.
  bool is_ring = false;
  std::vector<OutlinePiece> outline;  ///< Its outside; of a ring its inside.
  double circle_diameter_mm = 0.0;    ///< Of the bore, 0: none; of a ring its blank.
  double width_mm = 0.0;
};

/// A body where it stands when the train is assembled, the gearbox' axis being z.
struct PlacedBody {
  std::size_t body = 0;
  std::string name;  ///< planet_1 2 of 4, ...
  gearbox::Point middle;
  double turn_rad = 0.0;
  double from_mm = 0.0;  ///< Along the axis.
};

struct GearBodies {
  std::string name;  ///< Of the gearbox.
  std::vector<GearBody> bodies;
  std::vector<PlacedBody> placed;
};

/// What a layout leaves open of bodies.
struct BodySizes {
  std::vector<double> face_width_mm;  ///< By layer.
  std::vector<double> bore_mm;        ///< By gear, 0: none; rings have their blank.
};

/// All gears of a gearbox: layer 1 begins at 0, layer 2 where it ends. Throws
/// std::invalid_argument, a sentence, where a gear has no outline or a bore leaves no rim.
GearBodies gear_bodies(const DrawingLayout& layout, const BodySizes& sizes);

/// Where a point of a body lies in the gearbox.
gearbox::Point placed_point(const PlacedBody& placed, const gearbox::Point& point);

}  // namespace torquewright::report
