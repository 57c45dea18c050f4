// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Takes each joint's feedforward_torque_Nm into its commanded position: stiffness (command -
/// position) + feedforward is stiffness (command + feedforward / stiffness - position), so that the
/// controller's law with its delay and its limit holds as it is stated. The channel is then empty.
/// Throws io::SpecError for a joint without a stated law, or whose stiffness is zero or to be
/// found: there is then no position that would be the same.
void add_feedforward(const Rig& rig, Log& log);

}  // namespace torquewright::identification
