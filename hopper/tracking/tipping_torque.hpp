// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "hopper/tracking/linearisation.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Returns the torque of each drive alone (drives x 1, at its output) that moves the centre of
/// pressure of the touching points from the middle between two edges of their polygon to one of
/// them, of points on a line between its ends, where a foot begins to tip. It starts from the
/// middle, wherever `at` has it: a scale, which does not vanish where a plan stands on an edge.
/// Points are of one height. Infinite where a drive does not move it, or where the points span no
/// length or bear nothing (docs/derivations/tracking.md eq. (12a)). None where a mechanism does not
/// reach the posture.
std::optional<Eigen::VectorXd> tipping_torques_Nm(WholeBody& body, const DrivenState& at,
                                                  const TouchingPoints& touches);

}  // namespace torquewright::hopper
