// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/LU>

#include "dynamics/momentum.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Mass, momentum and inertia of a robot, links of its loops among them. Where a posture cannot be
/// reached, of the bodies of its tree alone.
class RobotCentroid {
 public:
  /// The robot must outlive it.
  explicit RobotCentroid(const Robot& robot) : body_(robot) {}

  /// Of a position and velocity as dynamics::TreeState::set() has them.
  dynamics::Centroid at(const dynamics::VectorIn& position, const dynamics::VectorIn& velocity) {
    return body_.set(position, velocity) ? body_.centroid() : dynamics::centroid(body_.state());
  }

 private:
  WholeBody body_;
};

/// As pitch_inertia_kg_m2() of a tree, with what links of loops weigh.
inline double pitch_inertia_kg_m2(const Robot& robot, const Posture& posture) {
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(robot.tree.velocity_size());
  const dynamics::Centroid all = RobotCentroid(robot).at(position_of(robot.tree, posture), still);
  return 1.0 / all.inertia_kg_m2.inverse()(1, 1);
}

}  // namespace torquewright::hopper
