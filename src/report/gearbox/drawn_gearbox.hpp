// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/train/gear_train.hpp"

namespace torquewright::report {

/// What a drawing of a gearbox shows.
struct DrawnGearbox {
  std::string name;
  std::string topology;             ///< One of gearbox/train_parts.cpp.
  std::vector<std::int64_t> teeth;  ///< In the topology's order: S, P1, P2, F, O or S, P, R.
  std::int64_t planet_count = 0;
  double module_mm = 0.0;
  std::string ratio;                      ///< As text: "20" or "1067/52".
  double hollow_shaft_diameter_mm = 0.0;  ///< Not drawn unless positive.
  std::optional<double> ring_wall_mm;     ///< Behind the ring's root; default 2.25 module.
  gearbox::Cutters cutters = {};          ///< As far as they are stated.
  /// Profile shift of each gear in its modules; empty: none is shifted.
  std::vector<double> profile_shift = {};
  std::optional<double> layer_2_module_mm = {};  ///< Where it is another than the sun's layer's.
  std::vector<double> face_width_mm = {};        ///< Of each layer; empty: not stated.
  std::vector<std::string> cannot_exist = {};    ///< Names of conditions that no gearbox can miss.
};

}  // namespace torquewright::report
