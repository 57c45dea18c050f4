// SPDX-License-Identifier: Apache-2.0
#include "robot/model/workspace.hpp"

#include <cmath>

namespace torquewright::hopper {
namespace {

/// As a share of the limit, where there is one: margins have different units.
double crossed_by(const MechanismMargin& margin) {
  const double scale = std::abs(margin.limit);
  return scale > 0.0 ? -margin.margin / scale : -margin.margin;
}

WorkspacePlace place_at(const Mechanism& mechanism, double first_rad, double second_rad) {
  WorkspacePlace place;
  place.joint_rad = {first_rad, second_rad};
  SmallVector joint_rad(2);
  joint_rad << first_rad, second_rad;
  place.is_reached = mechanism.transfer(joint_rad, SmallVector::Zero(2)).has_value();
  double furthest = 0.0;
  for (const MechanismMargin& margin : mechanism.margins(joint_rad)) {
    if (!(crossed_by(margin) > furthest)) continue;
    furthest = crossed_by(margin);
    place.crossed = margin.name;
  }
  return place;
}

}  // namespace

std::map<std::string, std::size_t> Workspace::kept_out() const {
  std::map<std::string, std::size_t> count;
  for (const WorkspacePlace& place : places) {
    if (place.is_inside()) continue;
    ++count[place.is_reached ? place.crossed : "not reached"];
  }
  return count;
}

Workspace workspace_of(const Robot& robot, const Drivetrain& drivetrain, int steps) {
  Workspace workspace;
  for (std::size_t i = 0; i < 2; ++i) {
    const dynamics::Joint& joint = robot.tree.bodies[drivetrain.joints[i]].joint;
    workspace.joints[i] = joint.name;
    workspace.limits[i] = joint.limits;
  }
  const auto at = [&](std::size_t joint, int step) {
    const dynamics::JointLimits& limits = workspace.limits[joint];
    return std::lerp(limits.position_min, limits.position_max,
                     static_cast<double>(step) / static_cast<double>(steps));
  };
  for (int first = 0; first <= steps; ++first) {
    for (int second = 0; second <= steps; ++second) {
      workspace.places.push_back(place_at(*drivetrain.mechanism, at(0, first), at(1, second)));
    }
  }
  return workspace;
}

}  // namespace torquewright::hopper
