// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "simulation/run/simulate.hpp"

namespace torquewright::simulation {

/// A drive of round numbers for one joint: ratio 10, Kt 0.1 Nm/A (1 Nm per ampere at the output), R
/// 0.5 ohm, 48 V, rotor 1e-4 kg m^2 (0.01 kg m^2 at the output).
actuator::Actuator simple_actuator();

/// What it moves: 0.02 kg m^2; the same in the centre of 1 kg on 0.3 m; 1 kg on an axis; or it is
/// moved.
enum class Load { kFree, kPendulum, kLinearAxis, kDynamometer };
std::unique_ptr<Plant> simple_plant(Load load);
/// Two links of about 1 kg and 0.3 m.
std::unique_ptr<Plant> simple_arm();

actuator::Effect effect(std::string_view name, std::vector<double> values);
actuator::Effect harmonic_effect(std::string_view name, std::vector<actuator::Harmonic> harmonics,
                                 bool proportional = false);

/// Current (or what `kind` says) as a function of time, on knots of that step.
Excitation excitation(double duration_s, double step_s, const std::function<double(double)>& drive,
                      DriveKind kind = DriveKind::kCurrent);

SimulatedRun run(Load load, const actuator::Actuator& actuator, const Excitation& excitation,
                 const JointStart& start = {}, double longest_step_s = 2.5e-4);

}  // namespace torquewright::simulation
