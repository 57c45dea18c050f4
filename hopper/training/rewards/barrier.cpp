// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/barrier.hpp"

#include <cmath>

namespace torquewright::hopper {

double relaxed_log(double distance, double softness) {
  if (distance >= softness) return std::log(distance);
  const double share = (distance - 2.0 * softness) / softness;
  return std::log(softness) - 0.5 * (share * share - 1.0);
}

double relaxed_barrier(double value, double least, double greatest, double softness) {
  return relaxed_log(value - least, softness) + relaxed_log(greatest - value, softness);
}

}  // namespace torquewright::hopper
