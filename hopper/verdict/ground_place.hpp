// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/record/record.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Returns the mean place on the ground (x, y), in m, of the chosen contact points (points x 1) as
/// the robot stands at a position; of none the origin.
Eigen::Vector2d ground_place_m(const Robot& robot, const TouchingPoints& chosen,
                               const Eigen::VectorXd& position);

}  // namespace torquewright::hopper
