// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::test {

/// Forward kinematics: where the joints stand when the actuators stand so, up to whole turns of
/// these; of several postures the one that Newton's method reaches from the start, whose transfer()
/// has been checked to give the actuators' positions back. Empty where it finds none: beyond reach,
/// or behind a singularity. docs/derivations/mechanisms.md eq. (5).
std::optional<hopper::SmallVector> joint_position_rad(const hopper::Mechanism& mechanism,
                                                      const hopper::SmallVector& actuator_rad,
                                                      const hopper::SmallVector& start_rad);

}  // namespace torquewright::test
