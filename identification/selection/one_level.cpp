// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/one_level.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "actuator/effects/library.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

using actuator::Acts;
using actuator::Instant;

/// Of the largest: within it a law in proportion and one that is constant differ by a tenth of what
/// they explain, either way.
constexpr double kOneLevel = 0.2;
constexpr double kTail = 0.1;  ///< Of the samples at either end: a reversal passes every level.

struct Coordinate {
  const char* name = nullptr;
  double (*of)(const Instant&) = nullptr;
};

/// Whether its torque is the same at every speed.
bool is_constant(const actuator::EffectKind& kind) {
  const actuator::Effect one{
      &kind, std::vector<double>(kind.parameters.size(), 1.0), {}, false, ""};
  const auto torque = [&](double speed_rad_s) {
    Instant at;
    at.speed_rad_s = speed_rad_s;
    at.direction = 1.0;
    return kind.law(one, at);
  };
  return torque(1.0) == torque(2.0);
}

/// Of which the effect is a law; without a name where it is of none.
Coordinate coordinate_of(const std::string& effect) {
  const actuator::EffectKind* kind = actuator::find_effect(effect);
  if (kind == nullptr || kind->has_harmonics) return {};
  switch (kind->acts) {
    case Acts::kDrag:
      if (is_constant(*kind)) return {};
      return {"speed", [](const Instant& at) { return at.speed_rad_s; }};
    case Acts::kTorqueFactor:
      return {"current", [](const Instant& at) { return at.current_A; }};
    case Acts::kLoadFriction:
      return {"load", [](const Instant& at) { return at.load_torque_Nm; }};
    default:
      return {};
  }
}

std::vector<double> sizes_of(const Rows& rows, const Coordinate& coordinate) {
  std::vector<double> sizes;
  std::size_t block = 0;
  Eigen::Index row = 0;
  for (std::size_t s = 0; s < rows.signals().size(); ++s) {
    for (const std::size_t sample : rows.samples()[s]) {
      while (row >= rows.blocks()[block].begin + rows.blocks()[block].count) ++block;
      ++row;
      if (!rows.blocks()[block].is_held_out())
        sizes.push_back(std::abs(coordinate.of(rows.signals()[s].at[sample])));
    }
  }
  return sizes;
}

}  // namespace

void doubt_one_level(const Rows& rows, EquationResult& result) {
  for (NamedEffect& each : result.added) {
    const Coordinate coordinate = coordinate_of(each.effect);
    if (coordinate.name == nullptr || !each.doubt.empty()) continue;
    const std::vector<double> sizes = sizes_of(rows, coordinate);
    if (sizes.empty()) continue;
    const double low = optimization::lower_quantile(sizes, kTail);
    const double high = optimization::lower_quantile(sizes, 1.0 - kTail);
    if (high - low > kOneLevel * high) continue;
    each.doubt = fmt::format(
        "the log holds one level of the {}, {:.4g} to {:.4g}: there a constant, or any other law "
        "of "
        "it, does as well; other levels would tell",
        coordinate.name, low, high);
  }
}

}  // namespace torquewright::identification
