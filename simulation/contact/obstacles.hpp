// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/point.hpp"

namespace torquewright::simulation {

/// Where the bodies may touch the ground, which is the plane z = height.
struct GroundPoint {
  dynamics::BodyPoint point;
  double friction_coefficient = 0.0;
  /// Share of the normal velocity that comes back (Newton's, as Moreau's stepping has it). Where it
  /// would add energy, as it can with friction, less of it is taken.
  double restitution = 0.0;
  double radius_m = 0.0;  ///< Of a ball about the point, whose lowest place touches; 0: the point.
};

/// An end of a joint's range, hard and without restitution.
struct JointStop {
  Eigen::Index row = 0;  ///< Of the joint in vectors of velocities.
  double bound = 0.0;    ///< rad or m.
  double inward = 1.0;   ///< 1: the range lies above the bound; -1: below.
};

/// What stands at the lowest place of a ground point, as its body stands now.
dynamics::BodyPoint lowest_point(const dynamics::TreeState& state, const GroundPoint& point);

/// The ends of all joints' ranges that have one.
std::vector<JointStop> joint_stops(const dynamics::Tree& tree);

}  // namespace torquewright::simulation
