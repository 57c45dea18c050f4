// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "gearbox/sized_proof/layer_terms.hpp"

namespace torquewright::gearbox::sized {

/// low to high.
struct Range {
  double low = 0.0, high = 0.0;
  double middle() const { return low + 0.5 * (high - low); }
  double width() const { return high - low; }
};

/// Centre distances [mm] and shifts [modules].
using CellBox = std::array<Range, kVariables>;

/// constant + slope . (place - reference).
struct PlacedForm {
  double constant = 0.0;
  std::array<double, kVariables> slope{};
  std::array<double, kVariables> reference{};
};

/// What may hold a layer of a design, and what is known of it there.
struct LayerCell {
  CellBox box;
  double least_kg = 0.0, least_mm = 0.0, least_kg_m2 = 0.0;
  /// Of a millimetre of width, and how soft it is at least.
  double least_kg_per_mm = 0.0, least_kg_m2_per_mm = 0.0, least_softness = 0.0;
  std::array<double, 2> efficiency{1.0, 1.0};  ///< At most.
  std::vector<PlacedForm> masses = {};         ///< No layer is lighter than any of them.
  std::vector<PlacedForm> conditions = {};     ///< No design where one is above 0.
};

/// What else a layer is held to.
struct LayerLimits {
  double heaviest_kg = kInfinity;
  double most_kg_m2 = kInfinity;
};

/// Bounds a layer over a box and keeps what its conditions leave; false: nothing.
bool bound_cell(const LoadedTeeth& teeth, std::size_t layer, const Demands& demands,
                const LayerLimits& limits, LayerCell& cell);

}  // namespace torquewright::gearbox::sized
