// SPDX-License-Identifier: Apache-2.0
// Grease and rolling contacts of gears: torques of reducers measured over speed follow a power of
// it between 0 and 1, as shear-thinning lubricants do (Ostwald-de Waele).
#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"coefficient_Nm", 0.0, kInfinity, 0.0, "Drag at an output speed of 1 rad/s."},
    {"exponent", 0.0, 3.0, 1.0, "Power of the speed: below 1 the drag flattens with it."},
};

/// Below it the law is a straight line, so that its slope at rest is finite.
constexpr double kStraight_rad_s = 1e-3;

double law(const Effect& effect, const Instant& at) {
  const double speed_rad_s = std::abs(at.speed_rad_s);
  const double bent_rad_s = std::max(speed_rad_s, kStraight_rad_s);
  const double share = speed_rad_s / bent_rad_s;
  return -effect.values[0] * std::pow(bent_rad_s, effect.values[1]) * share * at.direction;
}

/// At powers of 0, 1 and 2.
constexpr std::string_view kTendsTo[] = {"coulomb_friction", "viscous_friction", "quadratic_drag"};

std::vector<std::vector<double>> starts(const Ranges&) {
  return {{0.0, 0.6}, {0.0, 0.3}, {0.0, 1.5}};
}

}  // namespace

const EffectKind power_law_drag = {
    .name = "power_law_drag",
    .acts = Acts::kDrag,
    .sentence =
        "Drag that grows with a power of the speed, as of grease that thins the faster it is "
        "sheared.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .tends_to = kTendsTo,
    .starts = starts,
};

}  // namespace torquewright::actuator::effects
