// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"coulomb_Nm", 0.0, kInfinity, 0.0, "Friction once it slips, at the output."},
    {"stiffness_Nm_rad", 0.0, kInfinity, kInfinity,
     "Slope before slip, at the output; infinite: it slips at once.", true},
};

double law(const Effect& /*effect*/, const Instant& at) { return -at.state; }

double state_rate(const Effect& effect, const Instant& at) {
  const double coulomb_Nm = effect.values[0];
  if (coulomb_Nm == 0.0) return 0.0;
  const double stiffness_Nm_rad = effect.values[1];
  const double slip = at.state / coulomb_Nm * at.direction;  // 1 once it slips
  return stiffness_Nm_rad * (1.0 - slip) * at.speed_rad_s;
}

constexpr std::string_view kContains[] = {"coulomb_friction"};

/// By the way to slip, from a thousandth of the travel to a tenth.
std::vector<std::vector<double>> starts(const Ranges& ranges) {
  std::vector<std::vector<double>> all;
  const double coulomb_Nm = 0.05 * ranges.torque_Nm;
  for (const double share : {0.001, 0.006, 0.03}) {
    all.push_back({coulomb_Nm, coulomb_Nm / (share * ranges.angle_rad)});
  }
  return all;
}

/// The whole friction: no region counts any of it.
double misjudged_Nm(const Effect& effect, const MotionExtremes& /*motion*/) {
  return effect.values[0];
}

/// Of its bristles, which stand on the frame.
double stiffness_Nm_rad(const Effect& effect) {
  return effect.values[0] > 0.0 ? effect.values[1] : 0.0;
}

constexpr double kTypicalLength_rad = 0.01;  ///< On which it comes to slip.

/// Friction's level at one length: its stiffness grows along.
std::vector<Probe> probes(const Ranges& /*ranges*/, std::span<const double> /*start*/,
                          std::span<const double> step) {
  const auto at = [](double level_Nm) {
    return std::vector<double>{level_Nm, level_Nm / kTypicalLength_rad};
  };
  return {{"coulomb_Nm", fmt::format("at a presliding length of {:.3g} rad", kTypicalLength_rad),
           at(step[0]), at(2.0 * step[0]), step[0]}};
}

}  // namespace

const EffectKind presliding_friction = {
    .name = "presliding_friction",
    .acts = Acts::kDynamics,
    .sentence = "Dry friction that first gives way elastically: hysteresis before slip (Dahl).",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = state_rate,
    .state = "friction torque at the output, in Nm",
    .stiffness_Nm_rad = stiffness_Nm_rad,
    .at_rest = AtRest::kOwnLaw,
    .excited_by = kCreeping,
    .contains = kContains,
    .starts = starts,
    .probes = probes,
    .misjudged_Nm = misjudged_Nm,
};

}  // namespace torquewright::actuator::effects
