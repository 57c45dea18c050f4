// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/harmonics.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr std::string_view kNeeds[] = {"output_position_rad", "output_velocity_rad_s",
                                       "output_torque_Nm"};

double law(const Effect& effect, const Instant& at) {
  return -harmonic_sum(effect.harmonics, at.output_angle_rad) * at.direction;
}

void gradient(const Effect& effect, const Instant& at, std::span<double> derivative) {
  harmonic_gradient(effect.harmonics, at.output_angle_rad, derivative);
  for (double& entry : derivative) entry *= -at.direction;
}

}  // namespace

const EffectKind position_dependent_friction = {
    .name = "position_dependent_friction",
    .acts = Acts::kDrag,
    .sentence = "Tight spots: dry friction that varies with the output angle, about its mean.",
    .parameters = {},
    .has_harmonics = true,
    .needs = kNeeds,
    .law = law,
    .gradient = gradient,
    .state_rate = nullptr,
    .state = "",
};

}  // namespace torquewright::actuator::effects
