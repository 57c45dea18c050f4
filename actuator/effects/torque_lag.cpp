// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"time_constant_s", 0.0, kInfinity, 0.0, "Time in which 63 % of a step is reached."},
};

double law(const Effect& /*effect*/, const Instant& at) { return at.state - at.input; }

double state_rate(const Effect& effect, const Instant& at) {
  const double time_constant_s = effect.values[0];
  return time_constant_s == 0.0 ? 0.0 : (at.input - at.state) / time_constant_s;
}

std::vector<std::vector<double>> starts(const Ranges& /*ranges*/) {
  return {{0.0}, {0.01}, {0.04}};
}

/// What is missing of a ramp; of the steepest change at most the change.
double misjudged_Nm(const Effect& effect, const MotionExtremes& motion) {
  return std::min(effect.values[0] * motion.torque_rate_Nm_s, 2.0 * motion.torque_Nm);
}

constexpr double kTypicalLag_s = 0.008;

std::vector<Probe> probes(const Ranges& /*ranges*/, std::span<const double> /*start*/,
                          std::span<const double> /*step*/) {
  return {{"share", fmt::format("of a lag of {:.3g} s", kTypicalLag_s), {}, {kTypicalLag_s}}};
}

}  // namespace

const EffectKind torque_lag = {
    .name = "torque_lag",
    .acts = Acts::kDynamics,
    .sentence =
        "The torque follows its command with a first-order lag. Its law is what is missing "
        "of the command.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = state_rate,
    .state = "torque that is there, in Nm",
    .follows_torque = true,
    .excited_by = kFastMotion,
    .stands_for = StandsFor::kSensorLag,
    .consequence =
        "As a lag of the torque it is late by so much; as one of the sensor nothing "
        "changes.",
    .starts = starts,
    .probes = probes,
    .misjudged_Nm = misjudged_Nm,
};

}  // namespace torquewright::actuator::effects
