// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "dynamics/tree_state.hpp"

namespace torquewright::hopper {

/// An impulse from outside on a body's centre of mass: who stumbles over the robot, or hits it.
struct Push {
  std::size_t body = 0;   ///< Index in the robot's tree; 0 is the base.
  std::string body_name;  ///< Name of that body, for reports.
  Eigen::Vector3d impulse_N_s = Eigen::Vector3d::Zero();  ///< In the world's axes.
  double time_s = 0.0;                                    ///< Time of the motion.
};

/// Adds the generalised force (n x 1) that gives the push's impulse when it acts for `step_s` on
/// the tree as it stands: J^T p / step. The body's own centre of mass is where it acts, wherever a
/// document believes it to be.
void add_push(const dynamics::TreeState& state, const Push& push, double step_s,
              dynamics::VectorOut force);

}  // namespace torquewright::hopper
