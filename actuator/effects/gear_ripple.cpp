// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/harmonics.hpp"

namespace torquewright::actuator::effects {
namespace {

double law(const Effect& effect, const Instant& at) {
  const double sum = harmonic_sum(effect.harmonics, at.output_angle_rad);
  return effect.proportional ? sum * at.load_torque_Nm : sum;
}

}  // namespace

const EffectKind gear_ripple = {
    .name = "gear_ripple",
    .acts = Acts::kOutputTorque,
    .sentence =
        "Errors of teeth and bearings: a torque that repeats with the output angle, fixed "
        "or in proportion to the load.",
    .parameters = {},
    .has_harmonics = true,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .may_be_proportional = true,
    .excited_by = kSlowTurn,
    .typical_order = 2.0,
};

}  // namespace torquewright::actuator::effects
