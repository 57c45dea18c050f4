// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr Parameter kParameters[] = {
    {"coefficient_1_K", -0.1, 0.1, 0.0, "Relative change per kelvin."},
};
constexpr std::string_view kNeeds[] = {"output_velocity_rad_s", "output_torque_Nm",
                                       "winding_temperature_K"};

double law(const Effect& effect, const Instant& at) {
  return 1.0 + effect.values[0] * (at.winding_temperature_K - at.reference_temperature_K);
}

void gradient(const Effect& /*effect*/, const Instant& at, std::span<double> derivative) {
  derivative[0] = at.winding_temperature_K - at.reference_temperature_K;
}

}  // namespace

const EffectKind friction_temperature = {
    .name = "friction_temperature",
    .acts = Acts::kDragFactor,
    .sentence = "Grease thins as it warms: all drag changes with temperature.",
    .parameters = kParameters,
    .has_harmonics = false,
    .needs = kNeeds,
    .law = law,
    .gradient = gradient,
    .state_rate = nullptr,
    .state = "",
};

}  // namespace torquewright::actuator::effects
