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
  bool is_reached = true;  ///< The linkage closes there, and is not singular.

  bool is_inside() const { return is_reached && crossed.empty(); }
};

/// Where a mechanism of two joints can stand within their ranges.
struct Workspace {
  std::array<std::string, 2> joints;
  std::array<dynamics::JointLimits, 2> limits;
  std::vector<WorkspacePlace> places;  ///< A grid over both ranges, their ends among it.

  /// How many places each margin, or "not reached", keeps out.
  std::map<std::string, std::size_t> kept_out() const;
};

/// Of a drivetrain of two joints with ranges, by `steps` steps of each.
Workspace workspace_of(const Robot& robot, const Drivetrain& drivetrain, int steps);

}  // namespace torquewright::hopper
