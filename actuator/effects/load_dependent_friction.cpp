// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"driving_coefficient", 0.0, kInfinity, 0.0,
     "Friction per torque while the motor drives: efficiency 1/(1 + k)."},
    {"backdriving_coefficient", 0.0, 1.0, 0.0,
     "Friction per torque while the load drives: efficiency 1 - k."},
};
constexpr std::string_view kNeeds[] = {"output_velocity_rad_s", "output_torque_Nm", "motor_current_A"};

bool is_driving(const Instant& at) { return at.load_torque_Nm * at.direction >= 0.0; }

double law(const Effect& effect, const Instant& at) {
  const double k = effect.values[is_driving(at) ? 0 : 1];
  return -k * std::abs(at.load_torque_Nm) * at.direction;
}

void gradient(const Effect& /*effect*/, const Instant& at, std::span<double> derivative) {
  const std::size_t side = is_driving(at) ? 0 : 1;
  derivative[side] = -std::abs(at.load_torque_Nm) * at.direction;
  derivative[1 - side] = 0.0;
}

}  // namespace

const EffectKind load_dependent_friction = {
    .name = "load_dependent_friction",
    .acts = Acts::kLoadFriction,
    .sentence =
        "Friction of loaded teeth and bearings, in proportion to the torque on the load, "
        "beyond the stated efficiencies.",
    .parameters = kParameters,
    .has_harmonics = false,
    .needs = kNeeds,
    .law = law,
    .gradient = gradient,
    .state_rate = nullptr,
    .state = "",
};

}  // namespace torquewright::actuator::effects
