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

/// Computes the torque of an effect with a history through a stretch, in Nm at the output; zeros
/// where the effect is neutral or there is no time. Rates are advanced exactly over parts of steps,
/// between which motion and input follow a cubic; before the first sample they have settled.
/// `speeds_rad_s`: of the parts; `motor_Nm`: what a lag follows, empty for a friction. Friction
/// passes the motion's low-pass (cut-off 0: none), because it is no sum of what the motion is; a
/// lag of a torque that has passed it needs none.
std::vector<double> torque_of_history_Nm(const actuator::Effect& effect,
                                         const std::vector<actuator::Instant>& at,
                                         const std::vector<double>& speeds_rad_s,
                                         const std::vector<double>& motor_Nm, double step_s,
                                         double cutoff_Hz);

}  // namespace torquewright::identification
