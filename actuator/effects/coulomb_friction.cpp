// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"coulomb_Nm", 0.0, kInfinity, 0.0, "Torque at the output."},
};

double law(const Effect& effect, const Instant& at) { return -effect.values[0] * at.direction; }

}  // namespace

const EffectKind coulomb_friction = {
    .name = "coulomb_friction",
    .acts = Acts::kDrag,
    .sentence =
        "Dry friction of seals, bearings and teeth: the same at every speed, against the "
        "motion.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .at_rest = AtRest::kLevel,
    .excited_by = kSteadySpeeds,
    .presence = Presence::kEvery,
};

}  // namespace torquewright::actuator::effects
