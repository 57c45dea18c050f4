// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"stiffness_Nm_rad", 0.0, kInfinity, 0.0, "Torque per angle, at the output."},
    {"neutral_angle_rad", -kInfinity, kInfinity, 0.0, "Of the output, at which it is relaxed."},
};

double law(const Effect& effect, const Instant& at) {
  return -effect.values[0] * (at.output_angle_rad - effect.values[1]);
}

/// Relaxed far away it is a constant.
constexpr std::string_view kTendsTo[] = {"torque_offset"};

/// Relaxed at zero, or at either end of a range about it.
std::vector<std::vector<double>> starts(const Ranges& ranges) {
  return {{0.0, 0.0}, {0.0, 0.5 * ranges.angle_rad}, {0.0, -0.5 * ranges.angle_rad}};
}

}  // namespace

const EffectKind parallel_spring = {
    .name = "parallel_spring",
    .acts = Acts::kOutputTorque,
    .sentence = "A spring from the frame to the output: torque in proportion to its angle.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .stiffness_Nm_rad = [](const Effect& effect) { return effect.values[0]; },
    .tends_to = kTendsTo,
    .starts = starts,
};

}  // namespace torquewright::actuator::effects
