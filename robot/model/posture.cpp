// SPDX-License-Identifier: Apache-2.0
#include "robot/model/posture.hpp"

#include <Eigen/LU>

#include "dynamics/momentum.hpp"

namespace torquewright::hopper {

Eigen::VectorXd position_of(const dynamics::Tree& tree, const Posture& posture) {
  Eigen::VectorXd position = dynamics::zero_position(tree);
  position.tail(posture.joints.size()) = posture.joints;
  return position;
}

const Posture* standing_posture(const std::vector<Posture>& postures) {
  const Posture* home = nullptr;
  for (const Posture& posture : postures) {
    if (posture.name == "stand") return &posture;
    if (posture.name == "home" && !posture.joints.isZero(0.0)) home = &posture;
  }
  return home;
}

double pitch_inertia_kg_m2(const dynamics::Tree& tree, const Posture& posture) {
  dynamics::TreeState state(tree);
  state.set(position_of(tree, posture), Eigen::VectorXd::Zero(tree.velocity_size()));
  // CAV = I^-1 (0, L, 0): with a rolled foot the axes couple, hence the inverse's element.
  return 1.0 / dynamics::centroid(state).inertia_kg_m2.inverse()(1, 1);
}

}  // namespace torquewright::hopper
