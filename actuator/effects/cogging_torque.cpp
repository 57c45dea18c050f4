// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/harmonics.hpp"

namespace torquewright::actuator::effects {
namespace {

double law(const Effect& effect, const Instant& at) {
  return harmonic_sum(effect.harmonics, at.motor_angle_rad);
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
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .excited_by = kSlowTurn,
    .typical_order = 2.0,
};

}  // namespace torquewright::actuator::effects
