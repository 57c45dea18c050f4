// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/task/standing_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "dynamics/point.hpp"
#include "dynamics/tree_state.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

/// Points nearer together along x are one: no sole lies between them.
constexpr double kSole_m = 0.01;

std::vector<Eigen::Vector3d> contact_places_m(const Robot& robot, const VectorXd& position) {
  dynamics::TreeState state(robot.tree);
  state.set(position, VectorXd::Zero(robot.tree.velocity_size()));
  std::vector<Eigen::Vector3d> places_m;
  for (const ContactPoint& contact : robot.contacts) {
    places_m.push_back(dynamics::point_position_m(state, touching_point(contact, state)));
  }
  return places_m;
}

void set_pitch(const dynamics::Tree& tree, double pitch_rad, VectorXd& position) {
  if (tree.base == dynamics::BaseKind::kPlanar) {
    position[2] = pitch_rad;
    return;
  }
  position.segment<4>(3) << std::cos(0.5 * pitch_rad), 0.0, std::sin(0.5 * pitch_rad), 0.0;
}

}  // namespace

void put_on_ground(const Robot& robot, VectorXd& position) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& place_m : contact_places_m(robot, position)) {
    lowest_m = std::min(lowest_m, place_m.z());
  }
  position[robot.tree.base == dynamics::BaseKind::kPlanar ? 1 : 2] -= lowest_m;
}

VectorXd standing_start(const Robot& robot, const Posture& posture) {
  VectorXd position = position_of(robot.tree, posture);
  const std::vector<Eigen::Vector3d> places_m = contact_places_m(robot, position);
  const auto [back, front] = std::minmax_element(
      places_m.begin(), places_m.end(),
      [](const Eigen::Vector3d& one, const Eigen::Vector3d& other) { return one.x() < other.x(); });
  const double length_m = front->x() - back->x();
  if (length_m > kSole_m) {
    set_pitch(robot.tree, std::atan2(front->z() - back->z(), length_m), position);
  }
  put_on_ground(robot, position);
  return position;
}

}  // namespace torquewright::hopper
