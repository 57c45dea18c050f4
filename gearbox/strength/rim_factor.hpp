// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace torquewright::gearbox {

/// The rim behind the teeth of a gear. Lengths in mm.
struct Rim {
  bool internal = false;
  double thickness_mm = 0.0;  ///< Thickness s_R, from the root circle.
  double module_mm = 0.0;
  double tooth_height_mm = 0.0;  ///< Height of a tooth, h_t.
};

/// The thinnest rim that has a factor [mm]; it must be exceeded.
double least_rim_mm(const Rim& rim);

/// Returns Y_B, by which a thin rim raises the root's stress (docs/derivations/strength.md eq.
/// (15)). Nothing where the rim is too thin for the standard.
std::optional<double> rim_factor(const Rim& rim);

}  // namespace torquewright::gearbox
