// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"gap_rad", 0.0, kInfinity, 0.0, "Whole width, at the output."},
};
constexpr std::string_view kNeeds[] = {"motor_position_rad", "output_position_rad"};

double law(const Effect& effect, const Instant& at) {
  const double half_rad = effect.values[0] / 2.0;
  if (std::abs(at.twist_rad) <= half_rad) return 0.0;
  return at.twist_rad - std::copysign(half_rad, at.twist_rad);
}

void gradient(const Effect& effect, const Instant& at, std::span<double> derivative) {
  const bool in_gap = std::abs(at.twist_rad) <= effect.values[0] / 2.0;
  derivative[0] = in_gap ? 0.0 : -std::copysign(0.5, at.twist_rad);
}

}  // namespace

const EffectKind backlash = {
    .name = "backlash",
    .acts = Acts::kDynamics,
    .sentence =
        "Play between teeth: within the gap the output follows nothing. Its law is the "
        "twist beyond the gap.",
    .parameters = kParameters,
    .has_harmonics = false,
    .needs = kNeeds,
    .law = law,
    .gradient = gradient,
    .state_rate = nullptr,
    .state = "",
};

}  // namespace torquewright::actuator::effects
