// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "robot/model/posture.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// The position of the tree in which the robot stands with its joints in a posture: the base leans
/// so that the sole is level (over one point it is upright), and the lowest contact point is on the
/// ground at z = 0. Requires a base that moves and contact points.
Eigen::VectorXd standing_start(const Robot& robot, const Posture& posture);

/// Raises or lowers the base until the lowest contact point is on the ground at z = 0.
void put_on_ground(const Robot& robot, Eigen::VectorXd& position);

}  // namespace torquewright::hopper
