// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/motion/motion.hpp"
#include "hopper/training/task/ready_task.hpp"

namespace torquewright::hopper {

/// A state on the way through a motion in which an episode may begin.
struct MidState {
  long control = 0;  ///< Control periods of the task's clock that are over there.
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  double turned_rad = 0.0;  ///< How far the base has turned about +y against the task's start.
};

/// The states of a motion of `robot` (as its document has it, before it is put into its plane) at
/// the task's control instants, so that its longest time in the air ends at the task's landing;
/// from the task's begin until then: what comes later is learned on the way. Throws io::SpecError,
/// naming the motion's file, where its base does not move as the robot's does, it is never in the
/// air or the task states no landing.
std::vector<MidState> mid_states(const ReadyTask& ready, const Robot& robot, const Motion& motion);

}  // namespace torquewright::hopper
