// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/tracking/linearisation.hpp"

namespace torquewright::hopper {

/// Returns the map (2 n x 2 n) from errors (2 n x 1) just before a touch-down to errors just after
/// it, where both are taken at the contact itself, early or late (docs/derivations/tracking.md eq.
/// (14)). `before` is the state in front of it, while `old` touch; `held` do so behind it. The
/// identity where no point comes down. None where a mechanism does not reach the posture.
std::optional<Eigen::MatrixXd> touch_down_map(WholeBody& body, const DrivenState& before,
                                              const TouchingPoints& old,
                                              const TouchingPoints& held);

}  // namespace torquewright::hopper
