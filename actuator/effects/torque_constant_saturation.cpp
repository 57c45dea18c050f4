// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"saturation_current_A", 0.0, kInfinity, kInfinity,
     "Current at which it sets in, in the actuator's convention.", true},
    {"exponent", 1.0, kInfinity, 2.0, "How sharply it sets in.", true},
};

double law(const Effect& effect, const Instant& at) {
  const double x = std::abs(at.current_A) / effect.values[0];
  const double p = effect.values[1];
  return std::pow(1.0 + std::pow(x, p), -1.0 / p);
}

std::vector<std::vector<double>> starts(const Ranges& ranges) {
  return {
      {0.8 * ranges.current_A, 2.0}, {1.6 * ranges.current_A, 2.0}, {1.2 * ranges.current_A, 4.0}};
}

}  // namespace

const EffectKind torque_constant_saturation = {
    .name = "torque_constant_saturation",
    .acts = Acts::kTorqueFactor,
    .sentence = "The iron saturates: each further ampere yields less torque.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .starts = starts,
};

}  // namespace torquewright::actuator::effects
