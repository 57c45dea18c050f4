// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"gap_rad", 0.0, kInfinity, 0.0, "Whole width, at the output."},
};

double law(const Effect& effect, const Instant& at) {
  const double half_rad = effect.values[0] / 2.0;
  if (std::abs(at.twist_rad) <= half_rad) return 0.0;
  return at.twist_rad - std::copysign(half_rad, at.twist_rad);
}

/// By the travel: from a gap that one just sees to a quarter of it.
std::vector<std::vector<double>> starts(const Ranges& ranges) {
  std::vector<std::vector<double>> all;
  for (const double share : {0.002, 0.005, 0.0125, 0.03, 0.08, 0.2}) {
    all.push_back({share * ranges.angle_rad});
  }
  return all;
}

/// The rotor crosses the gap under the motion's torque and gives off its momentum, sqrt(2 T b J),
/// in the time in which that torque changes by itself.
double misjudged_Nm(const Effect& effect, const MotionExtremes& motion) {
  if (motion.torque_Nm <= 0.0) return 0.0;
  const double momentum_Nm_s =
      std::sqrt(2.0 * motion.torque_Nm * effect.values[0] * motion.motor_inertia_kg_m2);
  return std::min(momentum_Nm_s * motion.torque_rate_Nm_s / motion.torque_Nm, motion.torque_Nm);
}

/// Half the gap, on the side on which the motor drives the load.
double twist_rad(const Effect& effect, double torque_Nm) {
  return torque_Nm == 0.0 ? 0.0 : std::copysign(0.5 * effect.values[0], torque_Nm);
}

constexpr double kTypicalGap_rad = 0.002;

std::vector<Probe> probes(const Ranges& /*ranges*/, std::span<const double> /*start*/,
                          std::span<const double> /*step*/) {
  return {{"share", fmt::format("of a gap of {:.3g} rad", kTypicalGap_rad), {}, {kTypicalGap_rad}}};
}

}  // namespace

const EffectKind backlash = {
    .name = "backlash",
    .acts = Acts::kDynamics,
    .sentence =
        "Play between teeth: within the gap the output follows nothing. Its law is the "
        "twist beyond the gap.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .in_train = TrainPart::kGap,
    .twist_rad = twist_rad,
    .starts = starts,
    .probes = probes,
    .misjudged_Nm = misjudged_Nm,
};

}  // namespace torquewright::actuator::effects
