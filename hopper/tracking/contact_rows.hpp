// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "dynamics/tree_state.hpp"
#include "hopper/tracking/reference.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Velocities of the points that touch, three rows each in the world's axes: J v, and what their
/// rates are while the tree's acceleration is zero (docs/derivations/rigid_body.md eq. (24): balls
/// roll).
struct ContactRows {
  Eigen::MatrixXd jacobian;   ///< (3 k x n)
  Eigen::VectorXd bias_m_s2;  ///< (3 k x 1)

  Eigen::MatrixXd heights() const;  ///< (k x n): the rows along the vertical.
};

ContactRows contact_rows(const Robot& robot, const dynamics::TreeState& state,
                         const TouchingPoints& touches);

}  // namespace torquewright::hopper
