// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/workshop/gear_bodies.hpp"

namespace torquewright::cli {

/// What the command line says of bodies.
struct StatedSizes {
  std::string file;                   ///< The result's.
  std::vector<double> face_width_mm;  ///< --face-width; one stands for both layers.
  std::vector<std::string> bore;      ///< --bore: "planet_1=5"
  bool are_needed = false;            ///< Solids are asked for.
};

/// Widths by layer, of the command line or else the result's, and bores by gear. Throws SpecError
/// where numbers are no sizes of these gears, and where a width is needed and nobody states it.
report::BodySizes body_sizes(const StatedSizes& stated, const std::vector<double>& of_result_mm,
                             const report::DrawingLayout& layout);

}  // namespace torquewright::cli
