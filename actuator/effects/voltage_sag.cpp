// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"resistance_ohm", 0.0, kInfinity, 0.0, "Of everything that lies before the drive."},
};

double law(const Effect& effect, const Instant& at) { return -effect.values[0] * at.bus_current_A; }

}  // namespace

const EffectKind voltage_sag = {
    .name = "voltage_sag",
    .acts = Acts::kBusVoltage,
    .sentence = "Battery and cables: the bus voltage falls as the drive draws current.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .needs = {.winding_voltage = true, .duty = true},
};

}  // namespace torquewright::actuator::effects
