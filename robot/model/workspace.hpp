// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A posture of two joints, and what keeps their mechanism from it.
struct WorkspacePlace {
  std::array<double, 2> joint_rad{};
  /// The margin that is crossed the furthest, as a share of its limit; empty: none is.
  std::string crossed;
  bool is_reached = true;   ///< The linkage closes there, and is not singular.
  bool is_in_range = true;  ///< Of both joints.

  bool is_inside() const { return is_reached && crossed.empty(); }
};

/// Where a mechanism of two joints can stand within their ranges, and beyond.
struct Workspace {
  std::array<std::string, 2> joints;
  std::array<dynamics::JointLimits, 2> limits;
  /// A grid over both ranges, their ends among it, and half of each range beyond either end.
  std::vector<WorkspacePlace> places;

  std::size_t in_range() const;  ///< How many places are.
  /// How many places within the ranges each margin, or "not reached", keeps out.
  std::map<std::string, std::size_t> kept_out() const;
  /// How far the mechanism itself lets a joint go from the grid's place nearest to zero, the other
  /// staying there: from and to, in rad, no further than the grid; both zero where that place is
  /// not inside.
  std::array<double, 2> own_range_rad(std::size_t joint) const;
};

/// Of a drivetrain of two joints with ranges, by `steps` steps of each range. `steps` is even.
Workspace workspace_of(const Robot& robot, const Drivetrain& drivetrain, int steps);

}  // namespace torquewright::hopper
