// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// The torque balance of a stretch under a hypothesis, in Nm at the output (N on a linear axis), by
/// the laws of actuator/ in the contract's order of losses: drive channel -> current -> torque with
/// its laws and lag -> less the rotor's inertia and drag -> mesh -> ripple. With a torque sensor:
/// what it measured less that. With the rig's model as the load: what the load needs of the motor
/// less what the motor gives. So torque that is missing on the output has its own sign on every
/// rig. Where an instant stands for a time in which the motion turns over, both directions count by
/// their shares. docs/derivations/identification.md section 12.
std::vector<double> torque_balance_Nm(const Bench& bench, const Hypothesis& hypothesis,
                                      const Signals& signals);

}  // namespace torquewright::identification
