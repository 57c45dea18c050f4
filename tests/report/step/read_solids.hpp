// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::test {

/// A solid as Open CASCADE reads it from a STEP file, in its place; lengths in mm.
struct ReadSolid {
  bool is_valid = false;           ///< By its own check of topology and geometry.
  double volume_mm3 = 0.0;         ///< Negative: inside out.
  std::array<double, 6> box_mm{};  ///< Least x, y, z, greatest x, y, z.
  /// Points on the boundaries of its lowest face: the outer one first.
  std::vector<std::vector<gearbox::Point>> bottom;
};

/// All solids of the text, in the file's order. Throws std::runtime_error where it is not read
/// whole.
std::vector<ReadSolid> read_solids(const std::string& text);

}  // namespace torquewright::test
