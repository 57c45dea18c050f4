// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"coulomb_Nm", 0.0, kInfinity, 0.0, "Sliding friction, at the output."},
    {"breakaway_Nm", 0.0, kInfinity, 0.0,
     "Friction at the onset of motion; at least the sliding one.", false, "coulomb_Nm"},
    {"stribeck_velocity_rad_s", 0.0, kInfinity, 1.0,
     "Output speed at which the excess has fallen to 1/e.", true},
};

/// exp(-(w/v)^2); at v = 0 the excess exists at rest only.
double fading_at(const Effect& effect, const Instant& at) {
  const double v_rad_s = effect.values[2];
  if (v_rad_s == 0.0) return at.speed_rad_s == 0.0 ? 1.0 : 0.0;
  const double ratio = at.speed_rad_s / v_rad_s;
  return std::exp(-ratio * ratio);
}

double law(const Effect& effect, const Instant& at) {
  const double fading = fading_at(effect, at);
  return -(effect.values[0] + (effect.values[1] - effect.values[0]) * fading) * at.direction;
}

constexpr std::string_view kContains[] = {"coulomb_friction"};

std::vector<std::vector<double>> starts(const Ranges& ranges) {
  std::vector<std::vector<double>> all;
  for (const double share : {0.02, 0.06, 0.2})
    all.push_back({0.0, 0.0, share * ranges.speed_rad_s});
  return all;
}

/// Breakaway's excess, at a velocity that is a twentieth of the greatest speed.
std::vector<Probe> probes(const Ranges& ranges, std::span<const double> start,
                          std::span<const double> step) {
  const double v_rad_s = 0.05 * ranges.speed_rad_s;
  return {{"breakaway_over_coulomb_Nm",
           fmt::format("at a Stribeck velocity of {:.3g} rad/s", v_rad_s),
           {start[0], 0.0, v_rad_s},
           {start[0], step[1], v_rad_s},
           step[1]}};
}

}  // namespace

const EffectKind stribeck_friction = {
    .name = "stribeck_friction",
    .acts = Acts::kDrag,
    .sentence =
        "Dry friction that falls from breakaway to its sliding value as the lubricant takes "
        "over.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .at_rest = AtRest::kBreakaway,
    .excited_by = kCreeping,
    .contains = kContains,
    .starts = starts,
    .presence = Presence::kMost,
    .probes = probes,
};

}  // namespace torquewright::actuator::effects
