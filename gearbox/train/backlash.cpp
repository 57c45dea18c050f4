// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/backlash.hpp"

#include <cmath>

namespace torquewright::gearbox {

ThreeKBacklash three_k_backlash(double ratio_1, double ratio_2, const ThreeKRadii& radii) {
  const double both = radii.sun_m + radii.fixed_ring_m;
  // Backlash adds up whatever the side: magnitudes. Only I2 > 1 makes the first one negative.
  return {std::abs(1.0 - ratio_2) / both, (1.0 + ratio_2 / ratio_1) / both,
          1.0 / radii.output_ring_m};
}

double planetary_backlash(double sun_radius_m, double ring_radius_m) {
  return 1.0 / (sun_radius_m + ring_radius_m);
}

}  // namespace torquewright::gearbox
