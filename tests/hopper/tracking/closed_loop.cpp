// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/tracking/closed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/momentum.hpp"
#include "hopper/demand/demand.hpp"
#include "hopper/demand/drive_reports.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/tracking/linearisation.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper::test {

using Eigen::Index;
using Eigen::VectorXd;

ClosedLoop::ClosedLoop(const Robot& robot, Controller& controller, Timing timing)
    : controller_(&controller),
      timing_(timing),
      body_(robot),
      engine_(own_engine(robot, {})),
      touches_(TouchingPoints::Constant(static_cast<Index>(robot.contacts.size()), false)) {}

void ClosedLoop::start(const VectorXd& position, const VectorXd& velocity, double time_s) {
  engine_->start(position, velocity);
  time_s_ = time_s;
  touches_.setConstant(false);
  controller_->start();
}

bool ClosedLoop::run_until(double until_s, const std::function<void()>& look) {
  const double step_s = timing_.control_s / timing_.steps;
  const double from_s = time_s_;
  const auto periods = static_cast<int>(std::ceil((until_s - from_s) / timing_.control_s - 1e-9));
  for (int period = 1; period <= periods; ++period) {
    controller_->control({time_s_, 0.0, timing_.control_s, position(), velocity(), touches_},
                         torque_Nm_);
    touches_.setConstant(false);
    for (int i = 0; i < timing_.steps; ++i) {
      if (!body_.set(position(), velocity())) return false;
      const VectorXd force = drive_jacobian(body_).transpose() * torque_Nm_;
      if (engine_->step(force, step_s) != EngineOutcome::kStepped) return false;
      for (Index point = 0; point < touches_.size(); ++point) {
        if (engine_->impulses_N_s()[3 * point + 2] > 0.0) touches_[point] = true;
      }
    }
    time_s_ = from_s + period * timing_.control_s;
    if (look) look();
  }
  return true;
}

Robot robot_of(const std::string& file) {
  return read_robot(std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/") + file).robot;
}

PlannedMotion::PlannedMotion(const std::string& robot_file, const std::string& motion_file)
    : robot(robot_of(robot_file)),
      motion(read_motion(
          robot,
          {std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/") + motion_file, {}, {}, {}})) {
  const ContactSchedule contacts = schedule_contacts(robot, {}, motion);
  const Demand demand = demand_of(robot, motion, contacts);
  reference = std::make_unique<Reference>(robot, motion, contacts, torques_by_dynamics(demand));
}

VectorXd on_ground(const Robot& robot, VectorXd position) {
  dynamics::TreeState state(robot.tree);
  state.set(position, VectorXd::Zero(robot.tree.velocity_size()));
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : robot.contacts) {
    lowest_m =
        std::min(lowest_m, dynamics::point_position_m(state, touching_point(contact, state)).z());
  }
  position[robot.tree.base == dynamics::BaseKind::kSpatial ? 2 : 1] -= lowest_m;
  return position;
}

Reference standing(const Robot& robot, const VectorXd& position, double duration_s) {
  const Index n = robot.tree.velocity_size();
  Motion motion;
  motion.times_s = {0.0, duration_s};
  motion.positions = on_ground(robot, position).replicate(1, 2);
  motion.velocities = Eigen::MatrixXd::Zero(n, 2);
  motion.has_effort.assign(robot.tree.bodies.size() - 1, false);
  motion.accelerations = motion.velocities;
  const ContactSchedule contacts = schedule_contacts(robot, {}, motion);
  const Demand demand = demand_of(robot, motion, contacts);
  return {robot, motion, contacts, torques_by_dynamics(demand)};
}

VectorXd crouch(const Robot& hopper) {
  constexpr double kKnee_rad = 1.4, kFootMiddle_m = 0.02;
  dynamics::TreeState state(hopper.tree);
  VectorXd position = dynamics::zero_position(hopper.tree);
  // The base's pitch, so that the weight is above the middle; the ankle levels the foot.
  double low_rad = -1.2, high_rad = 0.2;
  for (int halving = 0; halving < 60; ++halving) {
    const double pitch_rad = 0.5 * (low_rad + high_rad);
    position.segment<4>(3) << std::cos(0.5 * pitch_rad), 0, std::sin(0.5 * pitch_rad), 0;
    position[7] = kKnee_rad;
    position[8] = -kKnee_rad - pitch_rad;
    state.set(position, VectorXd::Zero(9));
    const double ankle_m =
        dynamics::point_position_m(state, {3, Eigen::Vector3d::Zero()}).x() + kFootMiddle_m;
    const bool leans_ahead = dynamics::centroid(state).position_m.x() > ankle_m;
    (leans_ahead ? high_rad : low_rad) = pitch_rad;
  }
  return on_ground(hopper, position);
}

}  // namespace torquewright::hopper::test
