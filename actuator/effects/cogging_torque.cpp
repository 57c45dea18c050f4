// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/harmonics.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr std::string_view kNeeds[] = {"motor_position_rad", "output_torque_Nm"};

double law(const Effect& effect, const Instant& at) {
  return harmonic_sum(effect.harmonics, at.motor_angle_rad);
}

void gradient(const Effect& effect, const Instant& at, std::span<double> derivative) {
  harmonic_gradient(effect.harmonics, at.motor_angle_rad, derivative);
}

}  // namespace

const EffectKind cogging_torque = {
    .name = "cogging_torque",
    .acts = Acts::kMotorSideTorque,
    .sentence =
        "The magnets pull at the stator's teeth: a torque that repeats with the rotor's "
        "angle, also without current.",
    .parameters = {},
    .has_harmonics = true,
    .needs = kNeeds,
    .law = law,
    .gradient = gradient,
    .state_rate = nullptr,
    .state = "",
};

}  // namespace torquewright::actuator::effects
