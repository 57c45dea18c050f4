// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// Returns the residual of a stretch's torque balance under a hypothesis, in Nm at the output (N on
/// a linear axis). The laws of actuator/ are applied in order: drive channel -> current -> torque
/// with its laws and lag -> less the rotor's inertia and drag -> mesh -> ripple. With a torque
/// sensor the residual is what it measured less that; with the rig's model as the load it is what
/// the load needs of the motor less what the motor gives. Either way torque that is missing on the
/// output has its own sign. Where a sample stands for a time in which the motion reverses, both
/// directions count by their shares (docs/derivations/identification.md section 12).
std::vector<double> torque_balance_Nm(const Bench& bench, const Hypothesis& hypothesis,
                                      const Signals& signals);

}  // namespace torquewright::identification
