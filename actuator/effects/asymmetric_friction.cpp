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

Probe difference(std::string parameter, std::size_t forward, std::span<const double> start,
                 std::span<const double> step) {
  Probe probe{std::move(parameter), "", {start.begin(), start.end()}, {}, step[forward]};
  probe.high = probe.low;
  probe.high[forward] += 0.5 * step[forward];
  probe.high[forward + 1] -= 0.5 * step[forward];
  return probe;
}

/// What both directions have in common is Coulomb and viscous friction.
std::vector<Probe> probes(const Ranges& /*ranges*/, std::span<const double> start,
                          std::span<const double> step) {
  return {difference("coulomb_difference_Nm", 0, start, step),
          difference("viscous_difference_Nm_s_rad", 2, start, step)};
}

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
    .at_rest = AtRest::kOwnLaw,
    .stands_for = StandsFor::kOffset,
    .consequence =
        "As an offset of a sensor the friction that both directions have in common "
        "remains, the mean of their two values; as asymmetric friction each direction "
        "has its own.",
    .contains = kContains,
    .probes = probes,
};

}  // namespace torquewright::actuator::effects
