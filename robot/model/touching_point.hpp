// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// The point of the body that is at a contact's lowest place: of a ball the one that is under its
/// centre as the body stands now. Its velocity is that of the material there, zero where the ball
/// rolls; as the ball rolls, other points take its place. docs/derivations/rigid_body.md,
/// eqs. (22)-(25).
dynamics::BodyPoint touching_point(const ContactPoint& contact, const dynamics::TreeState& state);

}  // namespace torquewright::hopper
