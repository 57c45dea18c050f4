// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/ground_place.hpp"

#include <algorithm>

#include "dynamics/point.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {

Eigen::Vector2d ground_place_m(const Robot& robot, const TouchingPoints& chosen,
                               const Eigen::VectorXd& position) {
  dynamics::TreeState state(robot.tree);
  state.set(position, Eigen::VectorXd::Zero(robot.tree.velocity_size()));
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (Eigen::Index i = 0; i < chosen.size(); ++i) {
    if (!chosen[i]) continue;
    const ContactPoint& contact = robot.contacts[static_cast<std::size_t>(i)];
    sum_m += dynamics::point_position_m(state, touching_point(contact, state)).head<2>();
  }
  return sum_m / static_cast<double>(std::max<Eigen::Index>(1, chosen.count()));
}

}  // namespace torquewright::hopper
