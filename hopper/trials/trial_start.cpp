// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/trial_start.hpp"

#include <algorithm>
#include <limits>

#include "dynamics/point.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

double lowest_m(const Robot& robot, dynamics::TreeState& state, const RunStart& start) {
  state.set(start.position, start.velocity);
  double least_m = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : robot.contacts) {
    least_m =
        std::min(least_m, dynamics::point_position_m(state, touching_point(contact, state)).z());
  }
  return least_m;
}

/// Of the base's height in the positions; none for a base that does not move.
Index height_row(dynamics::BaseKind base) { return base == dynamics::BaseKind::kPlanar ? 1 : 2; }

}  // namespace

RunStart start_of(const Robot& robot, const Reference& reference, const Trial& trial) {
  ReferenceInstant first;
  reference.at(reference.begins_s(), first);
  RunStart start{first.position, first.velocity};
  dynamics::TreeState state(robot.tree);
  const bool stands = !robot.contacts.empty() && robot.tree.base != dynamics::BaseKind::kFixed;
  const double before_m = stands ? lowest_m(robot, state, start) : 0.0;
  const auto joints = static_cast<Index>(robot.tree.bodies.size()) - 1;
  for (Index joint = 0; joint < joints; ++joint) {
    const auto& limits = robot.tree.bodies[static_cast<std::size_t>(joint) + 1].joint.limits;
    double& position = start.position.tail(joints)[joint];
    position = std::clamp(position + trial.initial_joint_position_rad[joint],
                          std::min(position, limits.position_min),
                          std::max(position, limits.position_max));
    start.velocity.tail(joints)[joint] += trial.initial_joint_velocity_rad_s[joint];
  }
  if (stands) {
    start.position[height_row(robot.tree.base)] += before_m - lowest_m(robot, state, start);
  }
  return start;
}

}  // namespace torquewright::hopper
