// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/local_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "gearbox/synthesis/inner_bound.hpp"

namespace torquewright::gearbox {
namespace {

/// Lighter designs first, then what is nearer to a design.
struct Standing {
  double violation = std::numeric_limits<double>::infinity();
  double mass_kg = std::numeric_limits<double>::infinity();

  bool is_better_than(const Standing& other) const {
    return violation != other.violation ? violation < other.violation : mass_kg < other.mass_kg;
  }
};

Standing standing_at(const InnerCase& inner, const std::array<double, 3>& point) {
  Standing standing;
  const auto mass_kg = mass_at(inner, point, &standing.violation);
  if (mass_kg) standing.mass_kg = *mass_kg;
  return standing;
}

}  // namespace

double ordinary_mass_kg(const InnerCase& inner) {
  const double centre_mm =
      0.5 * inner.module_mm[0] * (inner.teeth[0] + inner.teeth[1] + 0.4) * (1.0 + 1e-9);
  double mass_kg = 0.0;
  for (const std::size_t layer : {0U, 1U}) {
    const auto values = layer_values(inner, layer, centre_mm, 0.3);
    const auto& widths = values.width_mm;
    mass_kg += *std::max_element(widths.begin(), widths.end()) * values.mass_per_width_kg_mm;
  }
  return std::isfinite(mass_kg) ? mass_kg : std::numeric_limits<double>::infinity();
}

std::optional<InnerPoint> light_point(const InnerCase& inner, const InnerBox& box,
                                      const std::array<double, 3>& start, int trials, double step) {
  // The generator's bits, not the library's distributions: the same on every machine.
  std::mt19937 generator(1);
  const auto uniform = [&] { return static_cast<double>(generator()) * 0x1p-31 - 1.0; };
  std::array<double, 3> best = start;
  Standing standing = standing_at(inner, best);
  constexpr double kLeastStep = 1e-9;
  for (int trial = 0; trial < trials && step > kLeastStep; ++trial) {
    std::array<double, 3> point = best;
    for (std::size_t i = 0; i < 3; ++i) {
      const Interval& range = box[i == 0 ? 0 : 1];
      const double width = range.upper - range.lower;
      point[i] = std::clamp(point[i] + step * width * uniform() * std::abs(uniform()), range.lower,
                            range.upper);
    }
    const Standing here = standing_at(inner, point);
    if (here.is_better_than(standing)) {
      best = point;
      standing = here;
      step = std::min(0.5, step * 1.6);
    } else {
      step *= 0.96;
    }
  }
  if (!std::isfinite(standing.mass_kg)) return std::nullopt;
  return InnerPoint{best, standing.mass_kg};
}

}  // namespace torquewright::gearbox
