// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/temperature_factor.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr Parameter kParameters[] = {
    {"coefficient_1_K", -0.01, 0.01, 0.0, "Relative change per kelvin."},
};

}  // namespace

const EffectKind torque_constant_temperature = {
    .name = "torque_constant_temperature",
    .acts = Acts::kFluxFactor,
    .sentence = "Magnets weaken as they warm: torque constant and back-EMF fall together.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = temperature_factor,
    .state_rate = nullptr,
    .state = "",
    .needs = {.winding_temperature = true},
    .excited_by = kColdAndWarm,
};

}  // namespace torquewright::actuator::effects
