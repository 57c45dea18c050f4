// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/forward/candidate.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// Returns the names of all effects that a log may be told to lack: the actuator's library, and
/// errors of rig and log.
std::vector<std::string> nameable_effects();

/// Returns the ranges of speed, torque and angle that the stretches cover.
actuator::Ranges ranges_of(const Bench& bench, const std::vector<Signals>& signals);

/// Returns a change of a parameter that matters, by the unit at the end of its name: a force of the
/// order of the torque used, a viscous coefficient of that torque over the speed, and so on.
double size_of(std::string_view parameter, const actuator::Ranges& ranges);

/// Returns the candidate of an actuator's effect with scalar parameters, made from its record in
/// actuator/effects. It takes the place of a stated one of its kind, and of those that it contains.
EffectCandidate actuator_candidate(const actuator::EffectKind& kind,
                                   const actuator::Actuator& stated,
                                   const actuator::Ranges& ranges);

/// Returns the candidate with all its parameters equal, for logs that determine only what they have
/// in common.
EffectCandidate with_equal_parameters(EffectCandidate candidate);

/// Returns one wave of an effect that has harmonics. `scale` is the largest amplitude.
EffectCandidate wave_candidate(const actuator::EffectKind& kind, double order, bool proportional,
                               double scale);

/// Returns the first harmonic of the output's angle, which stands for an error of the rig's
/// gravity.
EffectCandidate imbalance_candidate(const actuator::Ranges& ranges);

/// Returns the candidate of a channel that is late.
EffectCandidate delay_candidate(Quantity channel);

/// Returns the candidate of a constant error of the torque's sensor, which is also exactly an
/// offset of the current or the difference of friction's two directions.
EffectCandidate offset_candidate(const actuator::Ranges& ranges);

/// Returns the candidate of a current sensor whose gain is another for positive currents than for
/// negative ones. Where both are the same it is the torque constant that is wrong.
EffectCandidate current_gain_candidate();

/// Returns the candidate of an output encoder that is off by a sine of its own angle, `order` times
/// a turn (1 or 2).
EffectCandidate encoder_candidate(std::size_t order, double scale_rad);

}  // namespace torquewright::identification
