// SPDX-License-Identifier: Apache-2.0
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

/// Share of the instant's time in which motor and load turn the same way.
double driving_share(const Instant& at) {
  return 0.5 * (1.0 + (at.load_torque_Nm < 0.0 ? -at.direction : at.direction));
}

double law(const Effect& effect, const Instant& at) {
  if (at.direction == 0.0) return 0.0;
  const double share = driving_share(at);
  return at.load_torque_Nm * (effect.values[1] * (1.0 - share) - effect.values[0] * share);
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
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .excited_by = kBothWaysUnderLoad,
    .presence = Presence::kMost,
};

}  // namespace torquewright::actuator::effects
