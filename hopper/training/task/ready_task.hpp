// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/skill/skill.hpp"
#include "hopper/training/task/task.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A term of a task with all of its numbers for one robot.
struct ReadyReward {
  const RewardTerm* term = nullptr;
  RewardNumbers numbers;
};

/// A task and the robot that is to do it, joined.
struct ReadyTask {
  Robot robot;  ///< In its plane, if the task says so.
  Task task;
  Skill skill;
  Eigen::VectorXd start_position;  ///< Of the tree, without what differs by episode.
  std::vector<ReadyReward> rewards;
};

/// Joins them. io::SpecError where the robot has no drive, no base that moves or no contact, not
/// the posture or the joints that the task names, or no plane where the task asks for one. It
/// begins on a level sole on the ground; whether it can stay there is not asked.
ReadyTask ready_task(const Robot& robot, const Task& task);

}  // namespace torquewright::hopper
