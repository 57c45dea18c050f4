// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearbox/synthesis/inner_case.hpp"

namespace torquewright::gearbox {

/// A range of the shift of a layer's planet, for a range of centre distances, and what is known of
/// the layer's designs in it.
struct LayerCell {
  InnerBox box;                ///< Centre distances and shifts that may hold a design.
  double mass_kg = 0.0;        ///< No layer in it is lighter.
  double width_mm = 0.0;       ///< Nor narrower.
  double inertia_kg_m2 = 0.0;  ///< Nor has less inertia at the output, where that is asked.
  std::array<double, 2> efficiency{1.0, 1.0};  ///< Nor loses less in its meshes.
  /// Nor is less soft, weighs or turns less, a millimetre of its width, where stiffness is asked.
  double softness_rad_mm_Nm = 0.0, kg_per_mm = 0.0, kg_m2_per_mm = 0.0;
};

/// A range of centre distances: designs lie only in pairs of its cells, one of each layer.
struct InnerNode {
  Interval centre_mm;
  std::array<std::vector<LayerCell>, 2> cells;
};

/// What is known of a node.
struct InnerBound {
  bool is_empty = false;
  /// Where one margin empties a layer: its layer and place.
  std::optional<std::pair<std::size_t, std::size_t>> empty_margin;
  double mass_kg = 0.0;            ///< No design in the node is lighter.
  std::array<double, 3> middle{};  ///< Centre distance and shifts where it may be that light.
};

/// Bounds a node and keeps what may hold a design lighter than `cutoff_kg`; splits shifts as long
/// as that helps more than splitting the centre distances would.
InnerBound bound_inner(const InnerCase& inner, double cutoff_kg, InnerNode& node);

/// The same in a hurry: no shifts are split, and the layers are bounded each by itself.
InnerBound bound_roughly(const InnerCase& inner, double cutoff_kg, InnerNode& node);

/// Mass at a point; nothing where a margin is not above 0. `violation` says how far, in all.
std::optional<double> mass_at(const InnerCase& inner, const std::array<double, 3>& point,
                              double* violation = nullptr);

}  // namespace torquewright::gearbox
