// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/motion/motion.hpp"
#include "hopper/training/task/ready_task.hpp"
#include "hopper/verdict/flights.hpp"

namespace torquewright::hopper {

/// A state on the way through a motion in which an episode may begin.
struct MidState {
  long control = 0;  ///< Control periods of the task's clock that are over there.
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  double turned_rad = 0.0;   ///< How far the base has turned about +y against the task's start.
  Eigen::VectorXd joint_Nm;  ///< What the motion asks of the joints there, rotors included.
};

/// When the longest time in the air of a motion of `robot` (as its document has it, before it is
/// put into its plane) begins and ends, in s since the motion's begin. Throws io::SpecError, naming
/// the motion's file, where its base does not move as the robot's does or it is never in the air.
TimeInAir flight_of(const ReadyTask& ready, const Motion& motion);

/// The states of a motion at the task's control instants since its begin, from it on to its end.
/// `motion` has efforts of all joints, else torques are 0.
std::vector<MidState> mid_states(const ReadyTask& ready, const Motion& motion);

/// Has the task's targets go by a motion: in each control period the PD law gives, on the motion's
/// own way, the mean of the torques that the motion asks for, and an action is a correction.
void set_course(const std::vector<MidState>& states, Skill& skill);

}  // namespace torquewright::hopper
