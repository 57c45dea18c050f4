// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"viscous_Nm_s_rad", 0.0, kInfinity, 0.0, "Torque per speed, at the output."},
};
constexpr std::string_view kNeeds[] = {"output_velocity_rad_s", "output_torque_Nm"};

double law(const Effect& effect, const Instant& at) { return -effect.values[0] * at.speed_rad_s; }

void gradient(const Effect& /*effect*/, const Instant& at, std::span<double> derivative) {
  derivative[0] = -at.speed_rad_s;
}

}  // namespace

const EffectKind viscous_friction = {
    .name = "viscous_friction",
    .acts = Acts::kDrag,
    .sentence = "Drag of grease and bearings that grows in proportion to the speed.",
    .parameters = kParameters,
    .has_harmonics = false,
    .needs = kNeeds,
    .law = law,
    .gradient = gradient,
    .state_rate = nullptr,
    .state = "",
};

}  // namespace torquewright::actuator::effects
