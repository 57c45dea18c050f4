// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"coulomb_positive_Nm", 0.0, kInfinity, 0.0, "Dry friction while the output moves forward."},
    {"coulomb_negative_Nm", 0.0, kInfinity, 0.0, "Dry friction while it moves backward."},
    {"viscous_positive_Nm_s_rad", 0.0, kInfinity, 0.0, "Viscous friction while it moves forward."},
    {"viscous_negative_Nm_s_rad", 0.0, kInfinity, 0.0, "Viscous friction while it moves backward."},
};

/// Share of the instant's time that is spent moving forward; none of either way at rest.
double forward_share(const Instant& at) {
  return at.direction == 0.0 ? 0.0 : 0.5 * (1.0 + at.direction);
}
double backward_share(const Instant& at) {
  return at.direction == 0.0 ? 0.0 : 0.5 * (1.0 - at.direction);
}

double law(const Effect& effect, const Instant& at) {
  const std::size_t side = at.direction < 0.0 ? 1 : 0;
  return -effect.values[0] * forward_share(at) + effect.values[1] * backward_share(at) -
         effect.values[side + 2] * at.speed_rad_s;
}

constexpr std::string_view kContains[] = {"coulomb_friction", "viscous_friction"};

}  // namespace

const EffectKind asymmetric_friction = {
    .name = "asymmetric_friction",
    .acts = Acts::kDrag,
    .sentence = "Dry and viscous friction with values of their own in each direction of motion.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .contains = kContains,
};

}  // namespace torquewright::actuator::effects
