// SPDX-License-Identifier: Apache-2.0
#include "robot/model/workspace.hpp"

#include <algorithm>
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
    if (place.is_inside() || !place.is_in_range) continue;
    ++count[place.is_reached ? place.crossed : "not reached"];
  }
  return count;
}

std::size_t Workspace::in_range() const {
  return static_cast<std::size_t>(std::count_if(
      places.begin(), places.end(), [](const WorkspacePlace& place) { return place.is_in_range; }));
}

std::array<double, 2> Workspace::own_range_rad(std::size_t joint) const {
  const auto nearest = [&](std::size_t which) {
    return std::min_element(places.begin(), places.end(),
                            [which](const WorkspacePlace& one, const WorkspacePlace& other) {
                              return std::abs(one.joint_rad[which]) <
                                     std::abs(other.joint_rad[which]);
                            })
        ->joint_rad[which];
  };
  const double start_rad = nearest(joint), held_rad = nearest(1 - joint);
  std::vector<const WorkspacePlace*> row;  // along the joint, ascending as the grid is
  for (const WorkspacePlace& place : places) {
    if (place.joint_rad[1 - joint] == held_rad) row.push_back(&place);
  }
  const auto start = std::find_if(row.begin(), row.end(), [&](const WorkspacePlace* place) {
    return place->joint_rad[joint] == start_rad;
  });
  if (!(*start)->is_inside()) return {0.0, 0.0};
  const auto is_outside = [](const WorkspacePlace* place) { return !place->is_inside(); };
  const auto last = std::find_if(start, row.end(), is_outside) - 1;
  const auto first = std::find_if(std::make_reverse_iterator(start), row.rend(), is_outside).base();
  return {(*first)->joint_rad[joint], (*last)->joint_rad[joint]};
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
  const int beyond = steps / 2;
  const auto is_within = [steps](int step) { return step >= 0 && step <= steps; };
  for (int first = -beyond; first <= steps + beyond; ++first) {
    for (int second = -beyond; second <= steps + beyond; ++second) {
      workspace.places.push_back(place_at(*drivetrain.mechanism, at(0, first), at(1, second)));
      workspace.places.back().is_in_range = is_within(first) && is_within(second);
    }
  }
  return workspace;
}

}  // namespace torquewright::hopper
