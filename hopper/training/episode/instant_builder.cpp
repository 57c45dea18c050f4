// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/episode/instant_builder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/point.hpp"
#include "hopper/verdict/goal.hpp"
#include "hopper/verdict/turn.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kOfBase = 9;   // velocity, height, turn, time, rate
constexpr Index kOfTrial = 4;  // voltage, temperature, friction, restitution
constexpr Index kOfBody = 5;   // factors of mass and inertia, shift of the centre of mass
constexpr Index kOfDrive = 3;  // factors of gain and strength, friction

/// Writes numbers one behind the other.
class Row {
 public:
  explicit Row(Eigen::Ref<VectorXd> out) : out_(out) {}
  void put(double value) { out_[at_++] = value; }
  template <typename Values>
  void put_all(const Eigen::DenseBase<Values>& values) {
    for (const auto value : values.reshaped()) put(static_cast<double>(value));
  }

 private:
  Eigen::Ref<VectorXd> out_;
  Index at_ = 0;
};

VectorXd ratios_of(const Robot& robot) {
  std::vector<double> ratios;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& one : drivetrain.actuators) {
      ratios.push_back(std::abs(one.transmission.ratio));
    }
  }
  return Eigen::Map<VectorXd>(ratios.data(), static_cast<Index>(ratios.size()));
}

}  // namespace

InstantBuilder::InstantBuilder(const ReadyTask& ready, WholeBody& body, const Command& command)
    : ready_(ready), ratio_(ratios_of(ready.robot)) {
  const Task& task = ready.task;
  at_.asked.phase = task.phase;
  at_.asked.turn_rad = task.goal.turn_rad;
  at_.asked.forward_m_s = command.forward_m_s;
  at_.asked.yaw_rad_s = command.yaw_rad_s;
  at_.asked.clearance_m = task.clearance_m;
  at_.asked.is_standing = task.goal.most_flights == 0;
  at_.asked.flights = task.goal.most_flights;
  const auto joints = static_cast<Index>(ready.robot.tree.bodies.size()) - 1;
  const auto points = static_cast<Index>(ready.robot.contacts.size());
  at_.reference_rad = ready.skill.hold_rad;
  at_.joint_least_rad.resize(joints);
  at_.joint_greatest_rad.resize(joints);
  for (Index i = 0; i < joints; ++i) {
    const auto& limits = ready.robot.tree.bodies[static_cast<std::size_t>(i) + 1].joint.limits;
    at_.joint_least_rad[i] = limits.position_min;
    at_.joint_greatest_rad[i] = limits.position_max;
  }
  at_.joint_Nm.setZero(joints);
  at_.load_Nm.setZero(ratio_.size());
  const auto actions = static_cast<Index>(ready.skill.outputs.size());
  for (VectorXd* action : {&at_.action, &at_.action_before, &at_.action_before_that}) {
    action->setZero(actions);
  }
  at_.touches = at_.touches_before = TouchingPoints::Constant(points, true);
  at_.impulse_N_s.setZero(3 * points);
  began_ = before_ = body.state().motion(0).R_WB;
  set_state(body, 0.0);
  at_.joint_rad_s_before = at_.joint_rad_s;
}

void InstantBuilder::begin_on_the_way(double time_s, double turned_rad) {
  at_.time_s = time_s;
  at_.turned_rad = turned_rad;
  // Behind the landing too: the first touch counts the flight.
  air_s_ = std::max(0.0, time_s - ready_.task.phase.take_off_s);
  began_ = base_attitude(ready_.robot.tree, ready_.start_position);
}

void InstantBuilder::follow(const MidState* state) {
  at_.followed_rad.resize(state == nullptr ? 0 : at_.reference_rad.size());
  if (state == nullptr) return;
  at_.followed_rad = state->position.tail(at_.reference_rad.size());
  at_.followed_turn_rad = state->turned_rad;
}

void InstantBuilder::begin(const Eigen::Ref<const VectorXd>& action) {
  at_.action_before_that = at_.action_before;
  at_.action_before = at_.action;
  at_.action = action;
  at_.joint_rad_s_before = at_.joint_rad_s;
  at_.touches_before = at_.touches;
  at_.touches.setConstant(false);
  at_.impulse_N_s.setZero();
  at_.joint_Nm.setZero();
  at_.load_Nm.setZero();
  steps_ = 0;
}

void InstantBuilder::note_step(MovedRobot& robot, double step_s) {
  ++steps_;
  at_.joint_Nm += robot.force().tail(at_.joint_Nm.size());
  at_.load_Nm += robot.contact_Nm_s().cwiseAbs().cwiseQuotient(ratio_) / step_s;
  const VectorXd& impulses = robot.engine().impulses_N_s();
  at_.impulse_N_s += impulses;
  for (Index point = 0; point < at_.touches.size(); ++point) {
    if (impulses[3 * point + 2] > 0.0) at_.touches[point] = true;
  }
}

const RewardInstant& InstantBuilder::finish(double time_s, bool fell, WholeBody& body,
                                            double ground_m) {
  const double steps = std::max(1, steps_);
  at_.joint_Nm /= steps;
  at_.load_Nm /= steps;
  at_.impulse_N_s /= steps;
  at_.time_s = time_s;
  at_.fell = fell;
  count_flights();
  set_state(body, ground_m);
  return at_;
}

void InstantBuilder::count_flights() {
  if (at_.is_in_air()) {
    air_s_ += ready_.task.control_period_s;
    return;
  }
  if (air_s_ >= kCountedFlight_s) ++at_.flights;
  air_s_ = 0.0;
}

void InstantBuilder::set_state(WholeBody& body, double ground_m) {
  dynamics::TreeState& state = body.state();
  const dynamics::BodyMotion& base = state.motion(0);
  const Index joints = at_.reference_rad.size();
  at_.joint_rad_s = state.velocity().tail(joints);
  at_.joint_rad.resize(joints);
  for (Index i = 0; i < joints; ++i) {
    at_.joint_rad[i] = state.joint_position(static_cast<std::size_t>(i) + 1);
  }
  at_.base_velocity_m_s = base.velocity_m_s;
  at_.base_rate_rad_s = base.R_WB.transpose() * base.angular_velocity_rad_s;
  at_.base_height_m = state.base_origin_m().z() - ground_m;
  at_.tilt_rad = Eigen::AngleAxisd(began_.transpose() * base.R_WB).angle();
  const Eigen::AngleAxisd turned(base.R_WB * before_.transpose());
  at_.turned_rad += turned.angle() * turned.axis().y();
  before_ = base.R_WB;
  const dynamics::Centroid centroid = body.centroid();
  at_.momentum_Nm_s = centroid.angular_momentum_Nm_s;
  at_.rotation_rad_s = centroid.angular_velocity_rad_s;
  set_foot(state, ground_m);
  at_.mass_offset_m += centroid.position_m.head<2>();
}

void InstantBuilder::set_foot(const dynamics::TreeState& state, double ground_m) {
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  at_.foot_velocity_m_s.setZero();
  at_.foot_height_m = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : ready_.robot.contacts) {
    const dynamics::BodyPoint point = touching_point(contact, state);
    const Eigen::Vector3d place_m = dynamics::point_position_m(state, point);
    middle_m += place_m;
    at_.foot_velocity_m_s += dynamics::point_velocity_m_s(state, point);
    at_.foot_height_m = std::min(at_.foot_height_m, place_m.z() - ground_m);
  }
  const auto points = static_cast<double>(ready_.robot.contacts.size());
  at_.foot_velocity_m_s /= points;
  at_.mass_offset_m = -middle_m.head<2>() / points;
}

Index InstantBuilder::privileged_count(const Robot& robot) {
  const auto bodies = static_cast<Index>(robot.tree.bodies.size());
  return kOfBase + 2 * (bodies - 1) + static_cast<Index>(robot.contacts.size()) + kOfTrial +
         kOfBody * bodies + kOfDrive * ratios_of(robot).size();
}

void InstantBuilder::write_privileged(Eigen::Ref<VectorXd> out, const Trial& trial) const {
  const ContactPoint& contact = ready_.robot.contacts.front();
  Row row(out);
  row.put_all(at_.base_velocity_m_s);
  row.put(at_.base_height_m);
  row.put(at_.turned_rad);
  row.put(at_.time_s);
  row.put_all(at_.base_rate_rad_s);
  row.put_all(at_.joint_rad);
  row.put_all(at_.joint_rad_s);
  row.put_all(at_.touches);
  row.put(trial.bus_voltage_factor);
  row.put(trial.winding_temperature_K.value_or(0.0));
  row.put(trial.friction_coefficient.value_or(contact.friction_coefficient));
  row.put(trial.restitution.value_or(contact.restitution));
  row.put_all(trial.mass_factor);
  row.put_all(trial.inertia_factor);
  row.put_all(trial.center_of_mass_shift_m);
  row.put_all(trial.controller_gain_factor);
  row.put_all(trial.motor_strength_factor);
  row.put_all(trial.further_friction_Nm);
}

}  // namespace torquewright::hopper
