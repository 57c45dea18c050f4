// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"inertia_kg_m2", 0.0, kInfinity, 0.0, "At the output."},
};

double law(const Effect& effect, const Instant& at) {
  return -effect.values[0] * at.acceleration_rad_s2;
}

}  // namespace

const EffectKind reflected_inertia = {
    .name = "reflected_inertia",
    .acts = Acts::kInertialTorque,
    .sentence = "Inertia of rotor and gears beyond what is stated.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .stands_for = StandsFor::kLoadInertia,
    .consequence =
        "As inertia of the rotor it takes torque wherever the actuator accelerates; as "
        "an error of the rig nothing changes.",
    .presence = Presence::kMost,
};

}  // namespace torquewright::actuator::effects
