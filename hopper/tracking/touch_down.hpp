// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/tracking/linearisation.hpp"

namespace torquewright::hopper {

/// What errors (2 n x 1) just before a touch-down are at the contact itself, early or late.
struct TouchDownSlopes {
  /// The errors just after it; (2 n x 2 n), docs/derivations/tracking.md eq. (14). The identity
  /// where no point comes down.
  Eigen::MatrixXd after;
  /// How much higher each point that comes down is than their mean; (points x 2 n).
  Eigen::MatrixXd unevenness;
};

/// `before` is the state in front of it, while `old` touch; `held` do so behind it. None where a
/// mechanism does not reach the posture.
std::optional<TouchDownSlopes> touch_down(WholeBody& body, const DrivenState& before,
                                          const TouchingPoints& old, const TouchingPoints& held);

}  // namespace torquewright::hopper
