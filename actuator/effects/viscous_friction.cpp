// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"viscous_Nm_s_rad", 0.0, kInfinity, 0.0, "Torque per speed, at the output."},
};

double law(const Effect& effect, const Instant& at) { return -effect.values[0] * at.speed_rad_s; }

}  // namespace

const EffectKind viscous_friction = {
    .name = "viscous_friction",
    .acts = Acts::kDrag,
    .sentence = "Drag of grease and bearings that grows in proportion to the speed.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .excited_by = kSteadySpeeds,
    .presence = Presence::kEvery,
};

}  // namespace torquewright::actuator::effects
