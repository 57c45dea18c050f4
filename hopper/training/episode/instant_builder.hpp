// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/training/episode/mid_motion.hpp"
#include "hopper/training/episode/moved_robot.hpp"
#include "hopper/training/task/ready_task.hpp"
#include "hopper/trials/trial.hpp"

namespace torquewright::hopper {

/// Gathers over the engine's steps of a control step what rewards are made of.
class InstantBuilder {
 public:
  /// At an episode's begin, with the robot as it stands there. The task must outlive it.
  InstantBuilder(const ReadyTask& ready, WholeBody& body, const Command& command);

  /// Of an episode that begins on the way through a motion: how late, and how far it has turned.
  void begin_on_the_way(double time_s, double turned_rad);
  /// What the motion that is followed has at the end of this control step; null: nothing.
  void follow(const MidState* state);
  void begin(const Eigen::Ref<const Eigen::VectorXd>& action);
  void note_step(MovedRobot& robot, double step_s);
  /// Ends the control step at that time after the begin.
  const RewardInstant& finish(double time_s, bool fell, WholeBody& body, double ground_m);

  /// What a critic sees beside the policy's inputs: base, joints and contacts as they are, how far
  /// the base has turned and for how long the episode goes on, and what the trial drew.
  static Eigen::Index privileged_count(const Robot& robot);
  void write_privileged(Eigen::Ref<Eigen::VectorXd> out, const Trial& trial) const;

 private:
  void set_state(WholeBody& body, double ground_m);
  void count_flights();
  void set_foot(const dynamics::TreeState& state, double ground_m);

  const ReadyTask& ready_;
  RewardInstant at_;
  Eigen::Matrix3d began_;   ///< Attitude of the base at the begin.
  Eigen::Matrix3d before_;  ///< And at the last control step.
  Eigen::VectorXd ratio_;   ///< Of each drive.
  double air_s_ = 0.0;      ///< For how long nothing has touched the ground.
  int steps_ = 0;
};

}  // namespace torquewright::hopper
