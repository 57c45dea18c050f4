// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"drag_Nm_s2_rad2", 0.0, kInfinity, 0.0, "Torque per squared speed, at the output."},
};

double law(const Effect& effect, const Instant& at) {
  return -effect.values[0] * at.speed_rad_s * std::abs(at.speed_rad_s);
}

}  // namespace

const EffectKind quadratic_drag = {
    .name = "quadratic_drag",
    .acts = Acts::kDrag,
    .sentence = "Windage and churning: drag that grows with the square of the speed.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .excited_by = kSteadySpeeds,
    .presence = Presence::kMost,
};

}  // namespace torquewright::actuator::effects
