// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/point.hpp"

namespace torquewright::simulation {

/// A point of a body that may touch the ground, which is the plane z = height.
struct GroundPoint {
  dynamics::BodyPoint point;
  double friction_coefficient = 0.0;
  /// Share of the normal velocity that comes back (Newton's restitution, as in Moreau's stepping),
  /// without dimension. Where it would add energy, as it can with friction, less of it is taken.
  double restitution = 0.0;
  /// Radius of a ball about the point, whose lowest place touches; 0: the point itself.
  double radius_m = 0.0;
};

/// An end of a joint's range, hard and without restitution.
struct JointStop {
  Eigen::Index row = 0;  ///< Row of the joint in vectors of velocities.
  double bound = 0.0;    ///< Position of the end, in rad or m.
  double inward = 1.0;   ///< 1: the range lies above the bound; -1: below.
};

/// Dry friction of a joint.
struct JointFriction {
  /// Row of the joint in vectors of velocities; of a joint that moves with others (a link's of a
  /// closed loop) one beyond these, by MovingBodies::joint_motion().
  Eigen::Index row = 0;
  double moving = 0.0;   ///< Friction while it moves, in N m or N.
  double resting = 0.0;  ///< The most that it holds at rest, no less.
};

/// Returns the lowest place of a ground point in its body's present posture.
dynamics::BodyPoint lowest_point(const dynamics::TreeState& state, const GroundPoint& point);

/// Returns the ends of all joints' ranges that are limited.
std::vector<JointStop> joint_stops(const dynamics::Tree& tree);
/// Returns the dry friction of all joints that have some.
std::vector<JointFriction> joint_frictions(const dynamics::Tree& tree);

}  // namespace torquewright::simulation
