// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"factor", 0.0, kInfinity, 1.0, "True torque constant over the stated one."},
};

double law(const Effect& effect, const Instant& /*at*/) { return effect.values[0]; }

}  // namespace

const EffectKind torque_constant_error = {
    .name = "torque_constant_error",
    .acts = Acts::kTorqueFactor,
    .sentence = "The torque constant itself is off by a factor.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .excited_by = kSeveralLoads,
    .stands_for = StandsFor::kTorqueScale,
    .consequence =
        "As an error of the torque constant all torques of the region change by the "
        "factor; as any other, none.",
};

}  // namespace torquewright::actuator::effects
