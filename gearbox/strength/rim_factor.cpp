// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/rim_factor.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::gearbox {

double least_rim_mm(const Rim& rim) {
  return rim.internal ? 1.75 * rim.module_mm : 0.5 * rim.tooth_height_mm;
}

std::optional<double> rim_factor(const Rim& rim) {
  if (!(rim.thickness_mm > least_rim_mm(rim))) return std::nullopt;
  // The printed forms end at s_R = 1.2 h_t and 3.5 m, where they are within 0.4 % of 1.
  const bool is_thick = rim.internal ? rim.thickness_mm >= 3.5 * rim.module_mm
                                     : rim.thickness_mm >= 1.2 * rim.tooth_height_mm;
  if (is_thick) return 1.0;
  const double factor = rim.internal
                            ? 1.15 * std::log(8.324 * rim.module_mm / rim.thickness_mm)
                            : 1.6 * std::log(2.242 * rim.tooth_height_mm / rim.thickness_mm);
  return std::max(1.0, factor);
}

}  // namespace torquewright::gearbox
