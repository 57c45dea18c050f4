// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/soft_layers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::gearbox::sized {
namespace {

struct Priced {
  double bound = 0.0;
  double excess = 0.0;  ///< By how much the widths are too soft.
};

/// The width that is least at the price: share b + price softness / b is convex.
Priced at_price(const std::array<SoftLayer, 2>& layers, double most_rad_Nm, double price) {
  constexpr double kRoundingShare = 1e-13;
  Priced priced{-price * most_rad_Nm, -most_rad_Nm};
  double size = price * most_rad_Nm;
  for (const SoftLayer& layer : layers) {
    if (!(layer.softness > 0.0)) {
      priced.bound += layer.share * layer.least_mm;
      size += layer.share * layer.least_mm;
      continue;
    }
    const double free_mm = layer.share > 0.0 ? std::sqrt(price * layer.softness / layer.share)
                                             : std::numeric_limits<double>::infinity();
    const double width_mm = std::min(std::max(free_mm, layer.least_mm), layer.widest_mm);
    const double soft = layer.softness / width_mm;
    priced.bound += layer.share * width_mm + price * soft;
    priced.excess += soft;
    size += layer.share * width_mm + price * soft;
  }
  priced.bound -= kRoundingShare * size;
  return priced;
}

}  // namespace

double least_sum(const std::array<SoftLayer, 2>& layers, double least_Nm_rad) {
  const double most_rad_Nm = 1.0 / least_Nm_rad;
  double softest = 0.0, largest = 0.0;
  for (const SoftLayer& layer : layers) {
    if (!(layer.softness > 0.0)) continue;
    softest += layer.softness / layer.widest_mm;
    largest += layer.share * layer.widest_mm;
  }
  if (softest * (1.0 - 1e-12) > most_rad_Nm) return std::numeric_limits<double>::infinity();
  // The bound is concave in the price, and its slope is the excess.
  double best = at_price(layers, most_rad_Nm, 0.0).bound;
  double low = 0.0, high = 1e6 * largest / most_rad_Nm;
  constexpr int kSteps = 60;
  for (int step = 0; step < kSteps && low < high; ++step) {
    const double price = low > 0.0 ? std::sqrt(low * high) : 1e-6 * high;
    const Priced priced = at_price(layers, most_rad_Nm, price);
    best = std::max(best, priced.bound);
    (priced.excess > 0.0 ? low : high) = price;
    if (low == 0.0 && high < 1e-12 * largest / most_rad_Nm) break;
  }
  return best;
}

}  // namespace torquewright::gearbox::sized
