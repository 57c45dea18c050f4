// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/forward/equation.hpp"

namespace torquewright::identification {

/// What can enter the torque balance of such a bench, but for waves.
std::vector<EffectCandidate> torque_candidates(const Bench& bench, const actuator::Ranges& ranges);

/// The torque balance as a forward equation, with every effect that can enter it. `fold_of_run`:
/// waves are sought in runs that may be fitted. Keeps references to the first two.
ForwardEquation torque_forward(const Bench& bench, const std::vector<Signals>& signals,
                               const std::vector<std::size_t>& fold_of_run);

}  // namespace torquewright::identification
