// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/planning/plane/planned_motion.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Contact points that coincide where nothing leaves the plane.
struct SolePoint {
  std::string name;                   ///< "heel", "toe".
  dynamics::BodyPoint point;          ///< The point, in the plane.
  std::vector<std::size_t> members;   ///< Contact points of the robot.
  double friction_coefficient = 0.0;  ///< The least friction coefficient of its members.
};

/// The part of the robot that moves where nothing leaves the sagittal plane: the three rows of a
/// frame (PlanFrame) and the joints whose axes stand across the plane. The other joints stay at 0
/// and bear what they must.
struct SagittalRobot {
  Robot robot;  ///< The robot on a planar base.
  double mass_kg = 0.0;
  std::vector<std::size_t> joints;   ///< Bodies of the joints that move.
  std::vector<Eigen::Index> moving;  ///< Rows of what moves: the frame's, then those joints'.
  std::vector<Eigen::Index> held;    ///< Rows of joints that stay at 0.
  std::vector<double> directions;    ///< By joint of `joints`: +1 about +y, -1 about -y, 0
                                     ///< where it does not carry the foot.
  std::size_t foot = 0;              ///< The body with the contact points.
  std::vector<SolePoint> sole;       ///< Points of the sole from back to front.

  Eigen::Index moving_count() const { return static_cast<Eigen::Index>(moving.size()); }
  std::size_t drive_count() const;
  /// Returns all rows of a vector from those that move; the others are 0.
  Eigen::VectorXd all_rows(const Eigen::VectorXd& moving_rows) const;
};

/// Position, velocity and acceleration of the tree on its planar base, or of rows in a frame: (n x
/// 1) each.
struct TreeMotion {
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd acceleration;
};
/// Converts rows in a frame (n x 1 each) to the tree's motion, and back.
TreeMotion tree_motion(const SagittalRobot& robot, PlanFrame frame, const TreeMotion& rows);
TreeMotion frame_motion(const SagittalRobot& robot, PlanFrame frame, const TreeMotion& tree);

/// Returns the robot in its plane. io::SpecError, naming what and by how much, where no plane holds
/// its motion: masses or contacts beside it, mechanisms whose two sides are not mirror images,
/// joints that lean out of it; where more than one body has contact points or its sole is not
/// level, or where nothing pulls it down (docs/derivations/collocation.md, "The plane").
SagittalRobot sagittal(const Robot& robot);

}  // namespace torquewright::hopper
