// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/effects/effect.hpp"

namespace torquewright::identification {

/// Whether an effect gives a torque before the mesh that has a history: a lag, or friction that
/// gives way before it slips. Parts of an elastic train have theirs elsewhere.
bool has_history(const actuator::Effect& effect);

/// Speeds of a stretch within its steps, some parts each, by the cubic through the samples around.
std::vector<double> speeds_of_parts_rad_s(const std::vector<actuator::Instant>& at, double step_s);

/// Computes the torque of a friction that has a history through a stretch, in Nm at the output;
/// zeros where it is neutral or there is no time. Its rate is advanced exactly over the parts,
/// whose speeds are `speeds_rad_s`. It passes the motion's low-pass (cut-off 0: none), because it
/// is no sum of what the motion is.
std::vector<double> friction_history_Nm(const actuator::Effect& effect,
                                        const std::vector<actuator::Instant>& at,
                                        const std::vector<double>& speeds_rad_s, double step_s,
                                        double cutoff_Hz);

/// The same of a lag, which follows the motor's torque: between samples by a cubic, and before the
/// first it has settled. Of a torque that has passed the low-pass, so that it needs none.
std::vector<double> lag_history_Nm(const actuator::Effect& effect,
                                   const std::vector<actuator::Instant>& at,
                                   const std::vector<double>& motor_Nm, double step_s);

}  // namespace torquewright::identification
