// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/temperature_factor.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr Parameter kParameters[] = {
    {"coefficient_1_K", -0.01, 0.02, 0.0, "Relative change per kelvin."},
};

}  // namespace

const EffectKind winding_resistance_temperature = {
    .name = "winding_resistance_temperature",
    .acts = Acts::kResistanceFactor,
    .sentence =
        "The winding's resistance grows as it warms; takes the place of copper's 0.0039 "
        "1/K.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = temperature_factor,
    .state_rate = nullptr,
    .state = "",
    .needs = {.winding_temperature = true, .winding_voltage = true},
    .excited_by = kColdAndWarm,
};

}  // namespace torquewright::actuator::effects
