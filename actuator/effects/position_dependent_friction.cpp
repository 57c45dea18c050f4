// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/harmonics.hpp"

namespace torquewright::actuator::effects {
namespace {

double law(const Effect& effect, const Instant& at) {
  return -harmonic_sum(effect.harmonics, at.output_angle_rad) * at.direction;
}

}  // namespace

const EffectKind position_dependent_friction = {
    .name = "position_dependent_friction",
    .acts = Acts::kDrag,
    .sentence = "Tight spots: dry friction that varies with the output angle, about its mean.",
    .parameters = {},
    .has_harmonics = true,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .typical_order = 1.0,
};

}  // namespace torquewright::actuator::effects
