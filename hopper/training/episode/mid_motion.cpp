// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/episode/mid_motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/point.hpp"
#include "dynamics/tree_state.hpp"
#include "hopper/verdict/turn.hpp"
#include "io/faults/refusal.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kClear_m = 2e-3;  // as ContactThresholds has it

/// Position and velocity on the base that the task's robot has: the motion's own, or its plane.
MidState on_base_of(const dynamics::Tree& tree, const VectorXd& position,
                    const VectorXd& velocity) {
  MidState state{0, position, velocity, 0.0, {}};
  if (position.size() == tree.position_size()) return state;
  const Index joints = position.size() - 7;
  state.position.resize(3 + joints);
  state.position << position[0], position[2], 2.0 * std::atan2(position[5], position[3]),
      position.tail(joints);
  state.velocity.resize(3 + joints);
  state.velocity << velocity[0], velocity[2], velocity[4], velocity.tail(joints);
  return state;
}

/// The motion's samples with how far each has turned and what it asks of the joints.
std::vector<MidState> samples_of(const ReadyTask& ready, const Motion& motion) {
  const dynamics::Tree& tree = ready.robot.tree;
  std::vector<MidState> samples;
  Eigen::Matrix3d before = base_attitude(tree, ready.start_position);
  double turned_rad = 0.0;
  const auto joints = static_cast<Index>(tree.bodies.size()) - 1;
  for (Index i = 0; i < motion.samples(); ++i) {
    samples.push_back(on_base_of(tree, motion.positions.col(i), motion.velocities.col(i)));
    samples.back().joint_Nm = motion.efforts.rows() == joints ? motion.efforts.col(i).eval()
                                                              : VectorXd::Zero(joints).eval();
    const Eigen::Matrix3d attitude = base_attitude(tree, samples.back().position);
    const Eigen::AngleAxisd turn(attitude * before.transpose());
    turned_rad += turn.angle() * turn.axis().y();
    before = attitude;
    samples.back().turned_rad = turned_rad;
  }
  return samples;
}

bool is_clear(const Robot& robot, const dynamics::TreeState& state) {
  return std::all_of(robot.contacts.begin(), robot.contacts.end(), [&](const ContactPoint& one) {
    return dynamics::point_position_m(state, touching_point(one, state)).z() > kClear_m;
  });
}

void require_fitting(const ReadyTask& ready, const Motion& motion) {
  if (!motion.has_base) io::refuse(motion.file, "says nothing of how the base moves");
  const bool is_planar = motion.positions.rows() < ready.robot.tree.position_size();
  if (is_planar) io::refuse(motion.file, "is a motion in the plane, and the task is not");
}

}  // namespace

TimeInAir flight_of(const ReadyTask& ready, const Motion& motion) {
  require_fitting(ready, motion);
  const std::vector<MidState> samples = samples_of(ready, motion);
  dynamics::TreeState state(ready.robot.tree);
  double begun_s = motion.times_s.front();
  TimeInAir longest;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    state.set(samples[i].position, samples[i].velocity);
    if (!is_clear(ready.robot, state)) {
      begun_s = motion.times_s[i];
    } else if (motion.times_s[i] - begun_s > longest.duration_s()) {
      longest = {begun_s, motion.times_s[i]};
    }
  }
  if (!(longest.duration_s() > 0.0)) {
    io::refuse(motion.file, "never leaves the ground: it teaches no flight");
  }
  return {longest.from_s - motion.times_s.front(), longest.until_s - motion.times_s.front()};
}

std::vector<MidState> mid_states(const ReadyTask& ready, const Motion& motion) {
  require_fitting(ready, motion);
  const std::vector<MidState> samples = samples_of(ready, motion);
  std::vector<MidState> states;
  for (long control = 0;; ++control) {
    const double time_s =
        motion.times_s.front() + static_cast<double>(control) * ready.task.control_period_s;
    const auto found = std::lower_bound(motion.times_s.begin(), motion.times_s.end(), time_s);
    if (found == motion.times_s.end()) return states;
    states.push_back(samples[static_cast<std::size_t>(found - motion.times_s.begin())]);
    states.back().control = control;
  }
}

void set_course(const std::vector<MidState>& states, Skill& skill) {
  for (std::size_t i = 0; i < skill.outputs.size(); ++i) {
    const Index joint = skill.acted[i];
    const auto target_rad = [&](const MidState& at) {
      const Index joints = at.joint_Nm.size();
      return at.position.tail(joints)[joint] +
             (at.joint_Nm[joint] +
              skill.gains.damping_Nm_s_rad[joint] * at.velocity.tail(joints)[joint]) /
                 skill.gains.stiffness_Nm_rad[joint];
    };
    PolicyOutput& output = skill.outputs[i];
    output.offset = 0.0;
    output.course.clear();
    for (std::size_t at = 0; at < states.size(); ++at) {
      const MidState& next = states[std::min(at + 1, states.size() - 1)];
      output.course.push_back(0.5 * (target_rad(states[at]) + target_rad(next)));
    }
  }
}

}  // namespace torquewright::hopper
