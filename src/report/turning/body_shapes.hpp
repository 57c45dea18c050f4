// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::report {

/// A line with a radius, in its body's frame; a ball where both ends are one point.
struct DrawnCapsule {
  Eigen::Vector3d from_m;
  Eigen::Vector3d to_m;
  double radius_m = 0.0;
};

struct DrawnBox {
  Eigen::Vector3d center_m;
  Eigen::Vector3d half_m;
  Eigen::Matrix3d axes;  ///< A column an axis, right-handed.
};

struct BodyShape {
  std::vector<DrawnCapsule> capsules;
  std::optional<DrawnBox> box;
};

/// What stands for bodies whose looks no document states, by body: capsules from each joint to
/// those it carries, to its contact points and collision spheres, of a last body to its centre of
/// mass, as thick as the body's mass makes them; collision spheres as they are; a base that has
/// none of these as the box of its mass and inertia too, where there is one.
std::vector<BodyShape> body_shapes(const hopper::Robot& robot);

/// Radius of a capsule with this length between its ends' centres whose volume has that mass at the
/// density of a robot's parts (2 kg a litre).
double capsule_radius_m(double mass_kg, double length_m);

/// The box of uniform density with a body's mass and inertia; none if no box has it.
std::optional<DrawnBox> box_of_inertia(const dynamics::RigidInertia& inertia);

}  // namespace torquewright::report
