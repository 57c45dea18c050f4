// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"factor", 0.0, kInfinity, 1.0, "True torque constant over the stated one."},
};
constexpr std::string_view kNeeds[] = {"motor_current_A", "output_torque_Nm"};

double law(const Effect& effect, const Instant& /*at*/) { return effect.values[0]; }

void gradient(const Effect& /*effect*/, const Instant& /*at*/, std::span<double> derivative) {
  derivative[0] = 1.0;
}

}  // namespace

const EffectKind torque_constant_error = {
    .name = "torque_constant_error",
    .acts = Acts::kTorqueFactor,
    .sentence = "The torque constant itself is off by a factor.",
    .parameters = kParameters,
    .has_harmonics = false,
    .needs = kNeeds,
    .law = law,
    .gradient = gradient,
    .state_rate = nullptr,
    .state = "",
};

}  // namespace torquewright::actuator::effects
