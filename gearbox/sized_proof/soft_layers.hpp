// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace torquewright::gearbox::sized {

/// A layer of face width b between two limits, as soft as softness / b, whose width counts.
struct SoftLayer {
  double least_mm = 0.0, widest_mm = 0.0;
  double softness = 0.0;  ///< In rad mm/Nm.
  double share = 0.0;     ///< Of a millimetre.
};

/// What the widths of two layers that are stiff enough together sum up to, by their shares, at
/// least; infinite where the widest are not. By weak duality: of the sum and a price times what
/// the layers are too soft the least over each width by itself, which any price makes a bound.
double least_sum(const std::array<SoftLayer, 2>& layers, double least_Nm_rad);

}  // namespace torquewright::gearbox::sized
