// SPDX-License-Identifier: Apache-2.0
// Wouterse, "Critical torque and speed of eddy current brake with widely separated soft iron
// poles", IEE Proceedings B 138 (1991): T/T_max = 2 / (v_c/v + v/v_c).
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"peak_Nm", 0.0, kInfinity, 0.0, "Greatest drag, at the output."},
    {"critical_rad_s", 0.0, kInfinity, 1.0, "Output speed at which the drag is greatest.", true},
};

double law(const Effect& effect, const Instant& at) {
  const double critical_rad_s = effect.values[1];
  const double square = critical_rad_s * critical_rad_s + at.speed_rad_s * at.speed_rad_s;
  if (square == 0.0) return 0.0;
  return -2.0 * effect.values[0] * critical_rad_s * at.speed_rad_s / square;
}

/// Far below the critical speed it is viscous friction of 2 T_max / w_c.
constexpr std::string_view kTendsTo[] = {"viscous_friction", "coulomb_friction"};

std::vector<std::vector<double>> starts(const Ranges& ranges) {
  std::vector<std::vector<double>> all;
  for (const double share : {0.4, 0.12, 1.2}) all.push_back({0.0, share * ranges.speed_rad_s});
  return all;
}

}  // namespace

const EffectKind eddy_current_drag = {
    .name = "eddy_current_drag",
    .acts = Acts::kDrag,
    .sentence =
        "Eddy currents in a conductor that moves through a field: drag that grows with the speed "
        "up to a critical one and falls beyond it.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .tends_to = kTendsTo,
    .starts = starts,
};

}  // namespace torquewright::actuator::effects
