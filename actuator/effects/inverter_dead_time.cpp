// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"voltage_V", 0.0, kInfinity, 0.0, "In the winding's convention."},
};

double sign_of(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

double law(const Effect& effect, const Instant& at) {
  return -effect.values[0] * sign_of(at.current_A);
}

}  // namespace

const EffectKind inverter_dead_time = {
    .name = "inverter_dead_time",
    .acts = Acts::kWindingVoltage,
    .sentence =
        "The bridge's dead time costs a constant voltage, against the current's sign; in the "
        "convention "
        "of /motor/torque_constant_convention: line to line under dc, else a phase's amplitude.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .needs = {.winding_voltage = true},
};

}  // namespace torquewright::actuator::effects
