// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/temperature_factor.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr Parameter kParameters[] = {
    {"coefficient_1_K", -0.1, 0.1, 0.0, "Relative change per kelvin."},
};

}  // namespace

const EffectKind friction_temperature = {
    .name = "friction_temperature",
    .acts = Acts::kDragFactor,
    .sentence = "Grease thins as it warms: all drag changes with temperature.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = temperature_factor,
    .state_rate = nullptr,
    .state = "",
    .needs = {.winding_temperature = true},
    .excited_by = kColdAndWarm,
};

}  // namespace torquewright::actuator::effects
