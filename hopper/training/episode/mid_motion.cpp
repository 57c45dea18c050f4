// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/episode/mid_motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
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
  MidState state{0, position, velocity, 0.0};
  if (position.size() == tree.position_size()) return state;
  const Index joints = position.size() - 7;
  state.position.resize(3 + joints);
  state.position << position[0], position[2], 2.0 * std::atan2(position[5], position[3]),
      position.tail(joints);
  state.velocity.resize(3 + joints);
  state.velocity << velocity[0], velocity[2], velocity[4], velocity.tail(joints);
  return state;
}

/// The motion's samples with how far each has turned.
std::vector<MidState> samples_of(const ReadyTask& ready, const Motion& motion) {
  const dynamics::Tree& tree = ready.robot.tree;
  std::vector<MidState> samples;
  Eigen::Matrix3d before = base_attitude(tree, ready.start_position);
  double turned_rad = 0.0;
  for (Index i = 0; i < motion.samples(); ++i) {
    samples.push_back(on_base_of(tree, motion.positions.col(i), motion.velocities.col(i)));
    const Eigen::Matrix3d attitude = base_attitude(tree, samples.back().position);
    const Eigen::AngleAxisd turn(attitude * before.transpose());
    turned_rad += turn.angle() * turn.axis().y();
    before = attitude;
    samples.back().turned_rad = turned_rad;
  }
  return samples;
}

/// When the longest time in the air ends; infinite where there is none.
double touch_down_s(const Robot& robot, const Motion& motion,
                    const std::vector<MidState>& samples) {
  dynamics::TreeState state(robot.tree);
  double begun_s = motion.times_s.front();
  double longest_s = 0.0;
  double at_s = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    state.set(samples[i].position, samples[i].velocity);
    const bool is_clear =
        std::all_of(robot.contacts.begin(), robot.contacts.end(), [&](const ContactPoint& one) {
          return dynamics::point_position_m(state, touching_point(one, state)).z() > kClear_m;
        });
    if (!is_clear) {
      begun_s = motion.times_s[i];
    } else if (motion.times_s[i] - begun_s > longest_s) {
      longest_s = motion.times_s[i] - begun_s;
      at_s = motion.times_s[i];
    }
  }
  return at_s;
}

void require_fitting(const ReadyTask& ready, const Robot& robot, const Motion& motion) {
  const dynamics::Tree& tree = robot.tree;
  if (!motion.has_base || tree.base == dynamics::BaseKind::kFixed) {
    io::refuse(motion.file, "says nothing of how the base moves");
  }
  if (tree.base == dynamics::BaseKind::kPlanar &&
      ready.robot.tree.base != dynamics::BaseKind::kPlanar) {
    io::refuse(motion.file, "is a motion in the plane, and the task is not");
  }
  if (!(ready.task.phase.landing_s > 0.0)) {
    io::refuse(motion.file,
               "is no reference for " + ready.task.file + ", which states no phase/landing_s");
  }
}

}  // namespace

std::vector<MidState> mid_states(const ReadyTask& ready, const Robot& robot, const Motion& motion) {
  require_fitting(ready, robot, motion);
  const Task& task = ready.task;
  const std::vector<MidState> samples = samples_of(ready, motion);
  const double lag_s = touch_down_s(ready.robot, motion, samples) - task.phase.landing_s;
  if (!std::isfinite(lag_s)) {
    io::refuse(motion.file, "never leaves the ground: it teaches no flight");
  }
  std::vector<MidState> states;
  const auto last = std::lround(task.phase.landing_s / task.control_period_s);
  for (long control = 1; control <= last; ++control) {
    const double time_s = static_cast<double>(control) * task.control_period_s + lag_s;
    const auto found = std::lower_bound(motion.times_s.begin(), motion.times_s.end(), time_s);
    if (found == motion.times_s.end()) break;
    if (time_s < motion.times_s.front()) continue;
    states.push_back(samples[static_cast<std::size_t>(found - motion.times_s.begin())]);
    states.back().control = control;
  }
  return states;
}

}  // namespace torquewright::hopper
