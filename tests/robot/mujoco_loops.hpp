// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"
#include "tests/dynamics/mujoco_engine.hpp"

namespace torquewright::test {

/// A file whose loops MuJoCo holds, beside a robot of ours that has mechanisms for them: joints
/// that ours does not have are cranks' and rods'. All is MuJoCo's own: gaps and their Jacobian G,
/// mass matrix. Limits, contacts and friction are switched off.
class MujocoLoops {
 public:
  MujocoLoops(const std::string& mjcf, const hopper::Robot& robot);

  /// Begins where a keyframe of the file stands, for a file whose own posture brings links in line.
  void begin_at_keyframe(int key);
  /// Moves cranks and rods by Newton's method on the gaps, from the file's posture on in small
  /// steps of the robot's joints, in the order of the robot's bodies. The gap left, m.
  double close(const Eigen::VectorXd& joints);
  double position(const std::string& joint);
  /// The velocity of a joint over those of the robot's own joints, while the loops stay closed.
  Eigen::RowVectorXd ratios(const std::string& joint);
  /// Over the robot's velocities, ours order; loops closed.
  Eigen::MatrixXd mass_matrix();
  /// Forces over the robot's velocities that move it so while its loops stay closed, dampers and
  /// springs among them: N^T (M (N a + N' v) + bias - passive).
  Eigen::VectorXd inverse_dynamics(const Eigen::VectorXd& velocity,
                                   const Eigen::VectorXd& acceleration);
  void weigh_nothing(const std::string& body);
  /// Balls of rods without the damping that hinges in their place do not have.
  void leave_balls_undamped();
  double total_mass_kg() { return mj_getTotalmass(&mujoco_.model()); }

 private:
  Eigen::MatrixXd gap_jacobian();
  Eigen::MatrixXd closed_motions();
  void set(const Eigen::VectorXd& q);

  MujocoEngine mujoco_;
  std::vector<Eigen::Index> own_;    ///< MuJoCo's velocities, in the order of ours.
  std::vector<Eigen::Index> links_;  ///< And those that ours does not have.
  Eigen::Index base_ = 0;            ///< Velocities of the base.
  Eigen::VectorXd q_;
};

}  // namespace torquewright::test
