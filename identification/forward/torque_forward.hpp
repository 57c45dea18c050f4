// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/forward/equation.hpp"

namespace torquewright::identification {

/// Returns all candidates of the torque balance of such a bench except waves.
std::vector<EffectCandidate> torque_candidates(const Bench& bench, const actuator::Ranges& ranges);

/// Returns the torque balance as a forward equation, with every effect that can enter it. Waves are
/// sought only in runs that may be fitted (`fold_of_run`). Keeps references to the first two.
ForwardEquation torque_forward(const Bench& bench, const std::vector<Signals>& signals,
                               const std::vector<std::size_t>& fold_of_run);

}  // namespace torquewright::identification
