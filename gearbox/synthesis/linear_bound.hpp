// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "gearbox/synthesis/slope.hpp"

namespace torquewright::gearbox {

/// constant + slopes . (offset of the centre distance, of the shift of the layer's planet).
struct LinearForm {
  double constant = 0.0;
  std::array<double, kInnerVariables> slopes{};
};

/// Not above (least) or not below (greatest) what is enclosed, wherever the offsets lie in theirs.
LinearForm linear_below(const Slope& range, const InnerBox& offsets);
LinearForm linear_above(const Slope& range, const InnerBox& offsets);

/// A layer over a cell: no mass is below any of `masses`, no design where one of `margins` is
/// negative.
struct LayerForms {
  std::vector<LinearForm> masses;
  std::vector<LinearForm> margins;
  std::array<double, kInnerVariables> middle{};  ///< What offsets are counted from.
};

/// constant + slopes . (centre distance, shift of planet 1, shift of planet 2): not negative.
struct JointForm {
  double constant = 0.0;
  std::array<double, 3> slopes{};
};

/// Greatest value that both layers' masses together are proved not to fall below on centre
/// distances and shifts in the box: a linear programme's dual in few steps, of which any
/// multipliers would do. With its place.
struct LinearBound {
  double mass_kg = 0.0;
  std::array<double, 3> place{};
};

LinearBound linear_bound(const std::array<const LayerForms*, 2>& layers,
                         const std::vector<JointForm>& joint, const std::array<Interval, 3>& box);

}  // namespace torquewright::gearbox
