// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hopper/skill/phase_times.hpp"
#include "hopper/training/rewards/reward_term.hpp"
#include "hopper/trials/named_range.hpp"
#include "hopper/verdict/goal.hpp"

namespace torquewright::hopper {

/// Numbers that a task gives a joint within one term; what is absent is the term's own.
struct JointNumbers {
  double weight = 1.0;
  std::optional<double> least;
  std::optional<double> greatest;
};

/// A term of a task's rewards. Absent numbers are the term's own.
struct TaskReward {
  const RewardTerm* term = nullptr;
  std::optional<double> weight, rate, least, greatest, softness;
  std::map<std::string, JointNumbers> joints;  ///< By name; joints that are not named: weight 1.
};

/// How an action becomes a target of a joint, and what draws the joint there. Absent: by the task's
/// rules for all joints.
struct TaskJoint {
  std::optional<double> offset_rad, scale_rad;
  std::optional<double> stiffness_Nm_rad, damping_Nm_s_rad;
};

/// How a task is learned: what of learning::TrainerOptions differs by task.
struct TaskLearning {
  int copies = 64;
  int steps_per_iteration = 200;  ///< Of each copy.
  int minibatch = 3200;
  double discount = 0.99;
  double first_deviation = 0.6;
  double least_deviation = 0.2;
  double entropy = 0.01;
  std::vector<int> layers = {256, 128, 64};
};

/// A document of kind `training_task`: what a policy is to do and what it is paid for
/// (docs/documents/training_task.md).
struct Task {
  std::string name;
  std::string file;      ///< As named by the user; of a task that comes with the program its name.
  std::string text;      ///< The document itself.
  bool in_plane = true;  ///< Whether the robot moves in the plane of x and z alone.
  double control_period_s = 0.01;
  double step_s = 0.002;  ///< Of the engine while it trains; the PD law acts in every step.
  double duration_s = 2.0;
  bool filters_sensors = false;  ///< Whether SensorFilter stands between sensors and policy.
  PhaseTimes phase;
  std::vector<int> history_steps;  ///< Control periods ago of which joints are seen.
  std::string posture = "stand";   ///< Of the start, by the robot's name for it.
  double start_joint_rad = 0.0;    ///< Start differs by at most so much, either way.
  double start_joint_rad_s = 0.0;
  double scale_rad = 1.0;              ///< Target = offset + scale * action, of all joints.
  double full_torque_error_rad = 1.0;  ///< Error for which a joint's drives give their peak torque.
  double damping_time_s = 0.03;        ///< Damping over stiffness.
  std::map<std::string, TaskJoint> joints;
  std::optional<Range> forward_m_s;  ///< Of commands; drawn at each episode's begin.
  double clearance_m = 0.0;
  double overload_probability = 0.0;  ///< That an overloaded gear ends the episode.
  Goal goal;
  std::vector<TaskReward> rewards;
  TaskLearning learning;
};

}  // namespace torquewright::hopper
