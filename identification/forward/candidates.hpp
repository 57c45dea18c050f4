// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/forward/candidate.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// Names of all effects that a log may be told to lack: the actuator's library, and what rig and
/// log may have done.
std::vector<std::string> nameable_effects();

/// What the stretches cover.
actuator::Ranges ranges_of(const Bench& bench, const std::vector<Signals>& signals);

/// A change of a parameter that matters, by the unit at the end of its name: a force of the order
/// of the torque used, a viscous coefficient of that torque over the speed, and so on.
double size_of(std::string_view parameter, const actuator::Ranges& ranges);

/// An effect of the actuator that is told by scalar parameters, by its record in actuator/effects.
/// It takes the place of a stated one of its kind, and of those that it contains.
EffectCandidate actuator_candidate(const actuator::EffectKind& kind,
                                   const actuator::Actuator& stated,
                                   const actuator::Ranges& ranges);

/// The same where a log determines only what its parameters have in common.
EffectCandidate with_equal_parameters(EffectCandidate candidate);

/// One wave of an effect that has harmonics. `scale`: the largest amplitude.
EffectCandidate wave_candidate(const actuator::EffectKind& kind, double order, bool proportional,
                               double scale);

/// The first harmonic of the output's angle that stands for the rig's gravity.
EffectCandidate imbalance_candidate(const actuator::Ranges& ranges);

/// A channel that is late.
EffectCandidate delay_candidate(Quantity channel);

/// A constant on the torque's sensor; exactly that of the current, and of friction's two
/// directions.
EffectCandidate offset_candidate(const actuator::Ranges& ranges);

/// A sensor of the current that has another gain for positive currents than for negative ones.
/// Where both are the same it is the torque constant that is wrong.
EffectCandidate current_gain_candidate();

/// A wave of the output's encoder: it is off by a sine of its own angle, once or twice a turn.
EffectCandidate encoder_candidate(std::size_t order, double scale_rad);

}  // namespace torquewright::identification
