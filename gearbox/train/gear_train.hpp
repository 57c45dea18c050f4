// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox {

/// Cutters of the roots; lengths in modules.
struct Cutters {
  /// Tip radius of the hob of sun and planets, in modules. Absent: ISO 53 profile A (0.38) is
  /// assumed, and a planet's hob is rounded less where its ring reaches deeper
  /// (docs/derivations/tooth_outline.md eq. (8)).
  std::optional<double> hob_tip_radius = {};
  /// Tip radius of the shaper of rings, in modules. Absent: 0.3 is assumed, less where a planet's
  /// tip reaches deeper.
  std::optional<double> shaper_tip_radius = {};
  std::optional<std::int64_t> shaper_teeth = {};  ///< Absent: as many as the planet has.
  /// How deep they cut the roots below the reference profile's middle line; absent: 1.25.
  std::optional<double> hob_addendum = {};
  std::optional<double> shaper_addendum = {};

  double hob_depth() const { return hob_addendum.value_or(1.25); }
  double shaper_depth() const { return shaper_addendum.value_or(1.25); }
};

/// The cutters that the problem states, the others absent.
Cutters stated_cutters(const Problem& problem);

/// A train as it was made.
struct GearTrain {
  std::string topology;             ///< One of train_parts.cpp.
  std::vector<std::int64_t> teeth;  ///< In the topology's order.
  std::vector<double> shifts;       ///< Profile shifts in modules, likewise.
  std::int64_t planet_count = 0;
  double module_mm = 0.0;
  std::vector<double> face_width_mm;  ///< Face widths by layer: one, or two for a 3K train.
  Cutters cutters = {};
  /// Module of planet 2 and the output ring, in mm, where it is another than the sun's.
  std::optional<double> layer_2_module_mm = {};

  /// Module of a layer, in mm: 0 that of the sun, 1 that of the output ring.
  double module_of_layer_mm(std::size_t layer) const {
    return layer == 0 ? module_mm : layer_2_module_mm.value_or(module_mm);
  }
};

/// A design of a problem as it is made; no face widths.
GearTrain gear_train(const Problem& problem, const Design& design);

}  // namespace torquewright::gearbox
