// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "identification/simulation.hpp"

namespace torquewright::identification {

/// A drive of round numbers on a rig of one joint: ratio 10, Kt 0.1 Nm/A (1 Nm a ampere at the
/// output), R 0.5 ohm, 48 V, rotor 1e-4 kg m^2 (0.01 kg m^2 at the output).
actuator::Actuator simple_actuator();
Rig simple_rig(LoadType type);

actuator::Effect effect(std::string_view name, std::vector<double> values);
actuator::Effect harmonic_effect(std::string_view name, std::vector<actuator::Harmonic> harmonics,
                                 bool proportional = false);

/// Current (or what `kind` says) as a function of time, on knots of that step.
Excitation excitation(double duration_s, double step_s, const std::function<double(double)>& drive,
                      DriveKind kind = DriveKind::kCurrent);

SimulatedRun run(const Rig& rig, const actuator::Actuator& actuator, const Excitation& excitation,
                 const JointStart& start = {}, double longest_step_s = 2.5e-4);

}  // namespace torquewright::identification
