// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/task/ready_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/planning/plane/sagittal_robot.hpp"
#include "hopper/tracking/drive_loops.hpp"
#include "hopper/training/task/standing_start.hpp"
#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<std::string> joint_names(const Robot& robot) {
  std::vector<std::string> names;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    names.push_back(robot.tree.bodies[body].joint.name);
  }
  return names;
}

void require_able(const Robot& robot, const Task& task) {
  const char* lacks = robot.tree.base == dynamics::BaseKind::kFixed ? "a base that moves"
                      : robot.contacts.empty()                      ? "contacts"
                      : robot.drivetrains.empty()                   ? "drives"
                                                                    : nullptr;
  if (lacks != nullptr) {
    io::refuse(task.file, fmt::format("{} lacks {}: there is nothing that it could learn to do",
                                      robot.name, lacks));
  }
}

void require_joints(const Robot& robot, const Task& task) {
  const std::vector<std::string> names = joint_names(robot);
  std::vector<io::Fault> faults;
  const auto require = [&](const std::string& joint, const std::string& path) {
    if (std::find(names.begin(), names.end(), joint) != names.end()) return;
    faults.push_back({task.file, path + "/" + joint,
                      fmt::format("{} has no such joint, only {}", robot.name, io::listed(names))});
  };
  for (const auto& [joint, numbers] : task.joints) require(joint, "/joints");
  for (std::size_t i = 0; i < task.rewards.size(); ++i) {
    for (const auto& [joint, numbers] : task.rewards[i].joints) {
      require(joint, fmt::format("/rewards/{}/joints", i));
    }
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

const Posture& posture_of(const Robot& robot, const Task& task) {
  std::vector<std::string> names;
  for (const Posture& posture : robot.postures) {
    if (posture.name == task.posture) return posture;
    names.push_back(posture.name);
  }
  io::refuse(task.file,
             fmt::format("begins in the posture \"{}\", which {} does not state{}", task.posture,
                         robot.name, names.empty() ? "" : ": it has " + io::listed(names)));
}

/// By joint: the most that its drives can give there in the start's posture.
VectorXd peak_joint_Nm(const Robot& robot, const VectorXd& position) {
  const auto joints = static_cast<Index>(robot.tree.bodies.size()) - 1;
  VectorXd peaks_Nm = VectorXd::Zero(joints);
  const VectorXd drives_Nm = peak_torques_Nm(robot);
  Index first = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    const auto size = static_cast<Index>(drivetrain.joints.size());
    SmallVector joint_rad(size);
    for (Index i = 0; i < size; ++i) {
      joint_rad[i] = position.tail(
          joints)[static_cast<Index>(drivetrain.joints[static_cast<std::size_t>(i)]) - 1];
    }
    const auto transfer = drivetrain.mechanism->transfer(joint_rad, SmallVector::Zero(size));
    for (Index i = 0; i < size && transfer; ++i) {
      peaks_Nm[static_cast<Index>(drivetrain.joints[static_cast<std::size_t>(i)]) - 1] =
          transfer->jacobian.col(i).cwiseAbs().dot(drives_Nm.segment(first, size));
    }
    first += size;
  }
  return peaks_Nm;
}

void set_gains(const Task& task, const std::vector<std::string>& names, const VectorXd& peaks_Nm,
               TargetGains& gains) {
  gains.stiffness_Nm_rad = peaks_Nm / task.full_torque_error_rad;
  gains.damping_Nm_s_rad = gains.stiffness_Nm_rad * task.damping_time_s;
  for (Index i = 0; i < peaks_Nm.size(); ++i) {
    const auto stated = task.joints.find(names[static_cast<std::size_t>(i)]);
    if (stated == task.joints.end()) continue;
    if (stated->second.stiffness_Nm_rad) {
      gains.stiffness_Nm_rad[i] = *stated->second.stiffness_Nm_rad;
      gains.damping_Nm_s_rad[i] = gains.stiffness_Nm_rad[i] * task.damping_time_s;
    }
    gains.damping_Nm_s_rad[i] = stated->second.damping_Nm_s_rad.value_or(gains.damping_Nm_s_rad[i]);
  }
}

void add_output(const Task& task, const std::string& joint, Index index, Skill& skill) {
  const auto stated = task.joints.find(joint);
  const TaskJoint numbers = stated == task.joints.end() ? TaskJoint{} : stated->second;
  PolicyOutput output;
  output.name = joint + "_target_rad";
  output.unit = "rad";
  output.offset = numbers.offset_rad.value_or(skill.hold_rad[index]);
  output.scale = numbers.scale_rad.value_or(task.scale_rad);
  skill.outputs.push_back(output);
  skill.acted.push_back(index);
}

void add_inputs(const Task& task, bool is_planar, const std::vector<std::string>& acted,
                Skill& skill) {
  const auto add = [&](const std::string& name, const char* unit, int delay = 0) {
    skill.inputs.push_back({name, unit, delay});
  };
  add("gravity_x", "1");
  if (!is_planar) add("gravity_y", "1");
  add("gravity_z", "1");
  if (!is_planar) add("base_rate_x_rad_s", "rad/s");
  add("base_rate_y_rad_s", "rad/s");
  if (!is_planar) add("base_rate_z_rad_s", "rad/s");
  for (const std::string& joint : acted) {
    add(joint + "_rad", "rad");
    add(joint + "_rad_s", "rad/s");
    for (const int ago : task.history_steps) {
      add(joint + "_error_rad", "rad", ago);
      add(joint + "_rad_s", "rad/s", ago);
    }
    add(joint + "_target_rad", "rad", 0);  // the last two actions
    add(joint + "_target_rad", "rad", 1);
  }
  if (task.phase.end_s > 0.0 || task.phase.period_s > 0.0) {
    add("phase_sin", "1");
    add("phase_cos", "1");
  }
  if (task.phase.landing_s > 0.0) {
    add("phase_flight", "1");
    add("phase_landing", "1");
  }
  if (task.forward_m_s) add("command_forward_m_s", "m/s");
}

RewardNumbers numbers_of(const Robot& robot, const TaskReward& reward,
                         const std::vector<std::string>& names) {
  RewardNumbers numbers = reward.term->usual;
  numbers.weight = reward.weight.value_or(numbers.weight);
  numbers.rate = reward.rate.value_or(numbers.rate);
  numbers.least = reward.least.value_or(numbers.least);
  numbers.greatest = reward.greatest.value_or(numbers.greatest);
  numbers.softness = reward.softness.value_or(numbers.softness);
  const auto joints = static_cast<Index>(names.size());
  numbers.joint_weight = VectorXd::Ones(joints);
  numbers.joint_least = VectorXd::Constant(joints, numbers.least);
  numbers.joint_greatest = VectorXd::Constant(joints, numbers.greatest);
  for (Index i = 0; i < joints; ++i) {
    const std::size_t body = static_cast<std::size_t>(i) + 1;
    if (reward.term->ends == JointEnds::kRanges) {
      numbers.joint_least[i] = robot.tree.bodies[body].joint.limits.position_min;
      numbers.joint_greatest[i] = robot.tree.bodies[body].joint.limits.position_max;
    }
    const auto stated = reward.joints.find(names[body - 1]);
    if (stated == reward.joints.end()) continue;
    numbers.joint_weight[i] = stated->second.weight;
    numbers.joint_least[i] = stated->second.least.value_or(numbers.joint_least[i]);
    numbers.joint_greatest[i] = stated->second.greatest.value_or(numbers.joint_greatest[i]);
  }
  return numbers;
}

/// Bodies of the joints that actions move.
std::vector<std::size_t> acted_joints(const Robot& robot, const std::vector<std::size_t>& moving) {
  std::vector<std::size_t> driven;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    driven.insert(driven.end(), drivetrain.joints.begin(), drivetrain.joints.end());
  }
  std::sort(driven.begin(), driven.end());
  if (!moving.empty()) {
    std::erase_if(driven, [&](std::size_t body) {
      return std::find(moving.begin(), moving.end(), body) == moving.end();
    });
  }
  return driven;
}

/// In the plane points of the sole that coincide are one: the same impulses in fewer unknowns.
void merge_contacts(const SagittalRobot& plane, Robot& robot) {
  std::vector<ContactPoint> merged;
  for (const SolePoint& point : plane.sole) {
    ContactPoint contact = robot.contacts[point.members.front()];
    contact.name = point.name;
    contact.point = point.point;
    contact.friction_coefficient = point.friction_coefficient;
    merged.push_back(std::move(contact));
  }
  robot.contacts = std::move(merged);
}

}  // namespace

ReadyTask ready_task(const Robot& robot, const Task& task) {
  require_able(robot, task);
  ReadyTask ready{robot, task, {}, {}, {}};
  std::vector<std::size_t> moving;
  if (task.in_plane) {
    const SagittalRobot plane = sagittal(robot);
    moving = plane.joints;
    ready.robot = plane.robot;
    merge_contacts(plane, ready.robot);
  }
  const std::vector<std::string> names = joint_names(ready.robot);
  require_joints(ready.robot, task);
  ready.start_position = standing_start(ready.robot, posture_of(ready.robot, task));
  Skill& skill = ready.skill;
  skill.file = task.file;
  skill.phase = task.phase;
  skill.control_period_s = task.control_period_s;
  skill.hold_rad = ready.start_position.tail(static_cast<Index>(names.size()));
  set_gains(task, names, peak_joint_Nm(ready.robot, ready.start_position), skill.gains);
  std::vector<std::string> acted;
  for (const std::size_t body : acted_joints(ready.robot, moving)) {
    acted.push_back(names[body - 1]);
    add_output(task, acted.back(), static_cast<Index>(body) - 1, skill);
  }
  const bool is_planar = ready.robot.tree.base == dynamics::BaseKind::kPlanar;
  add_inputs(task, is_planar, acted, skill);
  for (const TaskReward& reward : task.rewards) {
    ready.rewards.push_back({reward.term, numbers_of(ready.robot, reward, names)});
  }
  return ready;
}

}  // namespace torquewright::hopper
