// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/stiff_widths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::gearbox {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The width at which a layer is as soft as the other leaves room for.
double width_beside(const LayerWidth& layer, double most_rad_Nm, const LayerWidth& other,
                    double other_mm) {
  if (layer.softness <= 0.0) return 0.0;
  const double left = most_rad_Nm - (other.softness > 0.0 ? other.softness / other_mm : 0.0);
  return left > 0.0 ? layer.softness / left : kInfinite;
}

}  // namespace

std::optional<std::array<double, 2>> stiff_widths_mm(const std::array<LayerWidth, 2>& layers,
                                                     double most_rad_Nm) {
  const auto& [first, second] = layers;
  constexpr double kSlack = 1e-12;
  const double low =
      std::max(first.least_mm, width_beside(first, most_rad_Nm, second, second.most_mm));
  if (low > first.most_mm * (1.0 + kSlack) || second.least_mm > second.most_mm * (1.0 + kSlack)) {
    return std::nullopt;
  }
  // Beyond this width of the first, the second is at its least.
  const double high = std::min(
      first.most_mm, std::max(low, width_beside(first, most_rad_Nm, second, second.least_mm)));
  // Where neither is at a limit, d(weight) = 0 along the line of equal softness.
  double best = low;
  if (first.softness > 0.0 && second.softness > 0.0 && first.weight > 0.0) {
    const double root = std::sqrt(first.softness * first.weight);
    best = root / first.weight * (root + std::sqrt(second.softness * second.weight)) / most_rad_Nm;
  }
  const double width_mm = std::clamp(best, low, std::max(low, high));
  const double beside_mm =
      std::max(second.least_mm, width_beside(second, most_rad_Nm, first, width_mm));
  if (!(beside_mm <= second.most_mm * (1.0 + 1e-9))) return std::nullopt;
  return std::array{width_mm, beside_mm};
}

std::optional<std::array<double, 2>> stiff_widths_within_mm(const std::array<LayerWidth, 2>& layers,
                                                            double most_rad_Nm, double longest_mm) {
  const auto at = [&](double share) {
    std::array<LayerWidth, 2> weighed = layers;
    const double heaviest = std::max(layers[0].weight, layers[1].weight);
    for (LayerWidth& each : weighed) each.weight += share * (heaviest - each.weight);
    return stiff_widths_mm(weighed, most_rad_Nm);
  };
  const auto lightest = at(0.0);
  if (!lightest || (*lightest)[0] + (*lightest)[1] <= longest_mm) return lightest;
  // At a share of 1 a millimetre weighs the same in both: those are the shortest.
  double light = 0.0, short_enough = 1.0;
  for (int step = 0; step < 50; ++step) {
    const double middle = 0.5 * (light + short_enough);
    const auto widths_mm = at(middle);
    ((*widths_mm)[0] + (*widths_mm)[1] <= longest_mm ? short_enough : light) = middle;
  }
  return at(short_enough);
}

double least_softness(const std::array<LayerWidth, 2>& layers) {
  double sum = 0.0;
  for (const LayerWidth& each : layers) {
    if (each.softness > 0.0) sum += each.softness / each.most_mm;
  }
  return sum;
}

double least_weight(const std::array<LayerWidth, 2>& layers, double most_rad_Nm) {
  const auto widths_mm = stiff_widths_mm(layers, most_rad_Nm);
  if (!widths_mm) return kInfinite;
  return layers[0].weight * (*widths_mm)[0] + layers[1].weight * (*widths_mm)[1];
}

}  // namespace torquewright::gearbox
