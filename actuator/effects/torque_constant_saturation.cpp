// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"saturation_current_A", 0.0, kInfinity, kInfinity,
     "Current at which it sets in, in the actuator's convention.", true},
    {"exponent", 1.0, kInfinity, 2.0, "How sharply it sets in.", true},
};

double law(const Effect& effect, const Instant& at) {
  const double x = std::abs(at.current_A) / effect.values[0];
  const double p = effect.values[1];
  return std::pow(1.0 + std::pow(x, p), -1.0 / p);
}

std::vector<std::vector<double>> starts(const Ranges& ranges) {
  return {
      {0.8 * ranges.current_A, 2.0}, {1.6 * ranges.current_A, 2.0}, {1.2 * ranges.current_A, 4.0}};
}

Saturation saturation(const Effect& effect) { return {effect.values[0], effect.values[1]}; }

constexpr double kTypicalExponent = 2.0;

/// The whole of a saturation that sets in at the greatest current.
std::vector<Probe> probes(const Ranges& ranges, std::span<const double> /*start*/,
                          std::span<const double> /*step*/) {
  return {{"share",
           fmt::format("of a saturation at {:.3g} A, exponent {:g}", ranges.current_A,
                       kTypicalExponent),
           {},
           {ranges.current_A, kTypicalExponent}}};
}

}  // namespace

const EffectKind torque_constant_saturation = {
    .name = "torque_constant_saturation",
    .acts = Acts::kTorqueFactor,
    .sentence = "The iron saturates: each further ampere yields less torque.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .saturation = saturation,
    .excited_by = kSeveralLoads,
    .starts = starts,
    .presence = Presence::kMost,
    .probes = probes,
};

}  // namespace torquewright::actuator::effects
