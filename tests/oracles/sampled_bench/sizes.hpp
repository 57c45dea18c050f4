// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/situation.hpp"

namespace torquewright::oracles::sampled {

/// In which balance an effect shows, and how loud the channels are there.
enum class Equation { kTorque, kVelocity, kTwist, kBus };

Equation equation_of(const std::string& effect);
/// In-band rms of the channels' noise as it enters the balance.
double noise_rms(const Situation& situation, const Record& faultless, Equation equation);
/// In-band rms of what an effect changes in its balance, at the same motion and current.
double change_rms(const Situation& situation, const Record& record, const Record& faultless,
                  const std::string& effect);
/// The same of an oddity.
double oddity_rms(const Situation& situation, const Record& record, const Record& faultless);
/// Of each hidden effect, or of the oddity: change over noise.
std::vector<double> size_floors(const Situation& situation, const Record& record,
                                const Record& faultless);
/// What the machine's own balance leaves at the sampled instants, over the noise: the integrator's
/// error, which must drown.
double numerical_floors(const Situation& situation, const Record& faultless);
/// How far a first-order lag differs from a pure delay of the same time, in noise rms of the
/// torque.
double lag_against_delay_floors(const Situation& situation, const Record& faultless, double time_s);

}  // namespace torquewright::oracles::sampled
