// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hopper/skill/phase_times.hpp"
#include "hopper/tracking/reference.hpp"

namespace torquewright::hopper {

/// What a task asks of an episode at an instant.
struct Asked {
  PhaseTimes phase;
  double turn_rad = 0.0;     ///< How far the base turns about +y in all.
  double forward_m_s = 0.0;  ///< Commanded velocity of the base, along the world's x.
  double yaw_rad_s = 0.0;    ///< Commanded turning about the world's z.
  double clearance_m = 0.0;  ///< How high the foot goes in the air.
  bool is_standing = false;  ///< Whether it is to stand still.
  int flights = 0;           ///< How often it is to leave the ground at most.
};

/// A robot after a control step: all that a reward may be made of. Vectors by joint are of the
/// bodies after the base.
struct RewardInstant {
  double time_s = 0.0;  ///< Since the episode's begin.
  Asked asked;
  Eigen::VectorXd joint_rad;
  Eigen::VectorXd joint_rad_s;
  Eigen::VectorXd joint_rad_s_before;  ///< A control step ago.
  Eigen::VectorXd reference_rad;       ///< Where they stand in the posture of the start.
  Eigen::VectorXd joint_least_rad;     ///< Ends of their ranges,
  Eigen::VectorXd joint_greatest_rad;  ///< which may be infinite.
  Eigen::VectorXd joint_Nm;            ///< Mean torque at the joints over the control step.
  /// The policy's outputs before they are scaled, now and one and two steps ago.
  Eigen::VectorXd action, action_before, action_before_that;
  TouchingPoints touches, touches_before;  ///< Points that the ground pressed on in the step.
  /// Mean of the contacts' impulses of one step of the engine over the control step (3 points x 1).
  Eigen::VectorXd impulse_N_s;
  Eigen::Vector3d foot_velocity_m_s = Eigen::Vector3d::Zero();  ///< Of the contact points' middle.
  double foot_height_m = 0.0;  ///< Of the lowest contact point, above the ground.
  Eigen::Vector3d base_velocity_m_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d base_rate_rad_s = Eigen::Vector3d::Zero();  ///< In the base's axes.
  double base_height_m = 0.0;
  double turned_rad = 0.0;  ///< How far the base has turned about +y since the begin.
  double tilt_rad = 0.0;    ///< Angle of the base's attitude to that of the start.
  Eigen::Vector3d momentum_Nm_s = Eigen::Vector3d::Zero();   ///< Centroidal angular momentum (CAM).
  Eigen::Vector3d rotation_rad_s = Eigen::Vector3d::Zero();  ///< Centroidal rotation rate (CAV).
  /// From the contact points' middle to the centre of mass, along the world's x and y.
  Eigen::Vector2d mass_offset_m = Eigen::Vector2d::Zero();
  /// By drive, before its mesh: mean of |J^T lambda / dt| over the control step.
  Eigen::VectorXd load_Nm;
  /// Joints and turn of the base that the followed motion has at this time; without joints: none.
  Eigen::VectorXd followed_rad;
  double followed_turn_rad = 0.0;
  int flights = 0;    ///< It came down from, of at least kCountedFlight_s each.
  bool fell = false;  ///< A body that is no foot came to the ground in the step.

  bool is_in_air() const { return !touches.any(); }
};

}  // namespace torquewright::hopper
