// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hopper/motion/motion.hpp"

namespace torquewright::report {

/// A robot as lines between points that are fixed to its bodies.
struct Skeleton {
  struct Bone {
    std::size_t body;  ///< Whose line it is.
    std::size_t from;  ///< Points.
    std::size_t to;
  };
  std::vector<dynamics::BodyPoint> points;  ///< The bodies' origins first, in their order.
  std::vector<Bone> bones;
  std::vector<std::size_t> contacts;  ///< The points of the robot's contacts, in their order.
};

/// Lines from each joint to those it carries; of a last body to its contact points, or to its
/// centre of mass.
Skeleton skeleton_of(const hopper::Robot& robot);

/// A robot at one instant, from the side: x to the right, z up.
struct Pose {
  double time_s = 0.0;
  std::vector<Eigen::Vector2d> points;  ///< As of the skeleton [m].
  Eigen::Vector2d center_of_mass_m = Eigen::Vector2d::Zero();
};

/// Poses of a robot whose base is known; `positions` has one column a time.
std::vector<Pose> poses_of(const hopper::Robot& robot, const Skeleton& skeleton,
                           const std::vector<double>& times_s, const Eigen::MatrixXd& positions);

/// Requires that the motion says how the base moves.
std::vector<Pose> poses_at(const hopper::Robot& robot, const hopper::Motion& motion,
                           const Skeleton& skeleton, const std::vector<Eigen::Index>& samples);

}  // namespace torquewright::report
