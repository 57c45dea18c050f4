// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/preparation/balance.hpp"

namespace torquewright::identification {

/// Whether a gap can be felt: one side's motion is known, and the other side has a stated inertia
/// to move in the gap. (With both positions the twist itself shows it.)
bool shows_backlash(const Bench& bench);

/// Returns what a gap between motor and output adds to the torque residual of a stretch, in Nm at
/// the output. The side without an encoder is simulated in the gap: a motor against the measured
/// motion of the output; motor and load, both, where only the motor's is known.
/// docs/derivations/identification.md section 10.
std::vector<double> backlash_residual_Nm(const Balance& balance, double gap_rad,
                                         const Signals& signals);

}  // namespace torquewright::identification
