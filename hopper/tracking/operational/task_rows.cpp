// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/operational/task_rows.hpp"

#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "hopper/tracking/error_space.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Springs stand as the motion has them to so much, in rad or m, or after so many steps of Newton.
constexpr double kStraight = 1e-9;
constexpr int kMostSteps = 4;

/// World's axes of a base's translation, in the order of its velocities.
std::vector<Index> ways_of(const dynamics::Tree& tree) {
  if (tree.base == dynamics::BaseKind::kPlanar) return {0, 2};
  return {0, 1, 2};
}

Vector3d mean_place_m(const Robot& robot, const dynamics::TreeState& state,
                      const TouchingPoints& touches) {
  Vector3d sum_m = Vector3d::Zero();
  for (Index i = 0; i < touches.size(); ++i) {
    if (!touches[i]) continue;
    sum_m += dynamics::point_position_m(
        state, touching_point(robot.contacts[static_cast<std::size_t>(i)], state));
  }
  return sum_m / static_cast<double>(touches.count());
}

}  // namespace

TaskFrame::TaskFrame(const Robot& robot, const std::vector<RigidJoint>& rigid)
    : robot_(robot), rigid_(robot, rigid), actual_(robot), wanted_(robot) {
  const Index n = robot.tree.velocity_size();
  mass_.resize(n, n);
  bias_force_.resize(n);
  wanted_force_.resize(n);
  difference_.resize(n);
}

bool TaskFrame::set(const ReferenceInstant& wanted, const TouchingPoints& touches,
                    const VectorXd& position, const VectorXd& velocity) {
  instant_ = wanted;
  touches_ = touches;
  const AlignedError aligned = aligned_error(robot_.tree, wanted, position, velocity);
  position_ = aligned.position;
  velocity_ = aligned.velocity;
  if (!wanted_.set(wanted.position, wanted.velocity)) return false;
  wanted_center_ = wanted_.centroid();
  wanted_.inverse_dynamics(wanted.acceleration, wanted_force_);
  if (!actual_.set(position_, velocity_)) return false;
  if (!straighten_springs()) return false;
  place_feet();
  if (!actual_.set(position_, velocity_)) return false;
  actual_center_ = actual_.centroid();
  actual_.mass_matrix(mass_);
  actual_.inverse_dynamics(VectorXd::Zero(velocity_.size()), bias_force_);
  dynamics::position_difference(robot_.tree, position_, wanted.position, difference_);
  contacts_ = contact_rows(robot_, actual_.state(), touches_);
  springs_ = rigid_.rates(actual_);
  let_springs_turn(VectorXd::Zero(rigid_.size()));
  return true;
}

/// Eq. (10).
void TaskFrame::let_springs_turn(const VectorXd& rates) {
  rigid_velocity_ =
      velocity_ + rigid_.moved(springs_, contacts_, VectorXd(rates - springs_ * velocity_));
}

/// Eq. (10).
bool TaskFrame::straighten_springs() {
  if (rigid_.size() == 0) return true;
  const VectorXd wanted = rigid_.places(wanted_);
  for (int step = 0; step < kMostSteps; ++step) {
    const VectorXd off = wanted - rigid_.places(actual_);
    if (off.cwiseAbs().maxCoeff() <= kStraight) break;
    const VectorXd way =
        rigid_.moved(rigid_.rates(actual_), contact_rows(robot_, actual_.state(), touches_), off);
    dynamics::step_position(robot_.tree, VectorXd(position_), way, 1.0, position_);
    if (!actual_.set(position_, velocity_)) return false;
  }
  return true;
}

/// Moves the observed robot, eq. (1).
void TaskFrame::place_feet() {
  Vector3d by_m = wanted_center_.position_m - actual_.centroid().position_m;
  if (touches_.any()) {
    by_m = mean_place_m(robot_, wanted_.state(), touches_) -
           mean_place_m(robot_, actual_.state(), touches_);
  }
  const std::vector<Index> ways = ways_of(robot_.tree);
  for (std::size_t i = 0; i < ways.size(); ++i) position_[static_cast<Index>(i)] += by_m[ways[i]];
}

/// The rows of M that a base's translation has are those of the whole momentum, eq. (2).
MatrixXd TaskFrame::center_jacobian(const MatrixXd& mass) const {
  MatrixXd jacobian = MatrixXd::Zero(3, mass.cols());
  const std::vector<Index> ways = ways_of(robot_.tree);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    jacobian.row(ways[i]) = mass.row(static_cast<Index>(i)) / actual_center_.mass_kg;
  }
  return jacobian;
}

/// What forces at the base say of the acceleration of all mass, eq. (2).
Vector3d TaskFrame::center_acceleration(const VectorXd& force) const {
  Vector3d out = Vector3d::Zero();
  const std::vector<Index> ways = ways_of(robot_.tree);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    out[ways[i]] = force[static_cast<Index>(i)] / actual_center_.mass_kg;
  }
  out.z() -= robot_.tree.gravity_m_s2;
  return out;
}

TaskFrame::Block TaskFrame::center_of_mass() {
  Block block;
  block.jacobian = center_jacobian(mass_);
  block.bias = center_acceleration(bias_force_);
  block.lacking = {wanted_center_.position_m - actual_center_.position_m,
                   wanted_center_.velocity_m_s - actual_center_.velocity_m_s,
                   center_acceleration(wanted_force_)};
  block.axes = ways_of(robot_.tree);
  return block;
}

/// The base's rotations are velocities of the tree, about its own axes.
TaskFrame::Block TaskFrame::attitude() const {
  const bool is_planar = robot_.tree.base == dynamics::BaseKind::kPlanar;
  const Index first = is_planar ? 2 : 3;
  Block block;
  block.jacobian = MatrixXd::Zero(3, velocity_.size());
  if (is_planar) {
    block.axes = {1};
  } else {
    block.axes = {0, 1, 2};
  }
  for (std::size_t i = 0; i < block.axes.size(); ++i) {
    const Index axis = block.axes[i], at = first + static_cast<Index>(i);
    block.jacobian(axis, at) = 1.0;
    block.lacking.place[axis] = difference_[at];
    block.lacking.rate[axis] = instant_.velocity[at] - velocity_[at];
    block.lacking.acceleration[axis] = instant_.acceleration[at];
  }
  return block;
}

/// From the centre of mass.
TaskFrame::Block TaskFrame::point(std::size_t contact) {
  const auto motion_of = [&](WholeBody& body, const dynamics::Centroid& center) {
    const dynamics::BodyPoint at = touching_point(robot_.contacts[contact], body.state());
    return Motion{dynamics::point_position_m(body.state(), at) - center.position_m,
                  dynamics::point_velocity_m_s(body.state(), at) - center.velocity_m_s,
                  dynamics::point_bias_acceleration_m_s2(body.state(), at)};
  };
  const Motion wanted = motion_of(wanted_, wanted_center_);
  const Motion actual = motion_of(actual_, actual_center_);
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, velocity_.size());
  dynamics::point_jacobian(wanted_.state(),
                           touching_point(robot_.contacts[contact], wanted_.state()), jacobian);
  const Vector3d acceleration =
      jacobian * instant_.acceleration + wanted.acceleration - center_acceleration(wanted_force_);
  dynamics::point_jacobian(actual_.state(),
                           touching_point(robot_.contacts[contact], actual_.state()), jacobian);
  Block block;
  block.jacobian = jacobian - center_jacobian(mass_);
  block.bias = actual.acceleration - center_acceleration(bias_force_);
  block.lacking = {wanted.place - actual.place, wanted.rate - actual.rate, acceleration};
  block.axes = ways_of(robot_.tree);
  return block;
}

TaskFrame::Block TaskFrame::joint(std::size_t body) const {
  const Index at = robot_.tree.base_velocity_size() + static_cast<Index>(body) - 1;
  Block block;
  block.jacobian = MatrixXd::Zero(3, velocity_.size());
  block.jacobian(0, at) = 1.0;
  block.lacking.place[0] = difference_[at];
  block.lacking.rate[0] = instant_.velocity[at] - velocity_[at];
  block.lacking.acceleration[0] = instant_.acceleration[at];
  block.axes = {0};
  return block;
}

TaskFrame::Block TaskFrame::block_of(const OperationalTask& task) {
  switch (task.kind) {
    case TaskKind::kCenterOfMass:
      return center_of_mass();
    case TaskKind::kBaseAttitude:
      return attitude();
    case TaskKind::kPoint:
      return point(task.of);
    default:
      return joint(task.of);
  }
}

bool TaskFrame::is_active(const OperationalTask& task) const {
  if (task.kind == TaskKind::kPoint && touches_[static_cast<Index>(task.of)]) return false;
  if (task.when == TaskTime::kStance) return touches_.any();
  if (task.when == TaskTime::kFlight) return !touches_.any();
  return true;
}

void TaskFrame::rows(const std::vector<OperationalTask>& tasks, TaskRows& out) {
  const Index n = velocity_.size(), most = 3 * static_cast<Index>(tasks.size());
  out.jacobian.resize(most, n);
  out.task_of.clear();
  for (VectorXd* column : {&out.bias, &out.place_error, &out.rate_error, &out.acceleration,
                           &out.stiffness_1_s2, &out.damping_1_s, &out.weight}) {
    column->resize(most);
  }
  Index row = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const OperationalTask& task = tasks[i];
    if (!is_active(task)) continue;
    const Block block = block_of(task);
    for (const Index axis : block.axes) {
      const bool is_of_axes = task.kind != TaskKind::kJoint;
      if (is_of_axes && !task.along[static_cast<std::size_t>(axis)]) continue;
      out.jacobian.row(row) = block.jacobian.row(axis);
      out.bias[row] = block.bias[axis];
      out.place_error[row] = block.lacking.place[axis];
      out.rate_error[row] =
          block.lacking.rate[axis] + block.jacobian.row(axis).dot(velocity_ - rigid_velocity_);
      out.acceleration[row] = block.lacking.acceleration[axis];
      out.stiffness_1_s2[row] = task.stiffness_1_s2();
      out.damping_1_s[row] = task.damping_1_s();
      out.weight[row] = task.weight;
      out.task_of.push_back(i);
      ++row;
    }
  }
  out.jacobian.conservativeResize(row, n);
  for (VectorXd* column : {&out.bias, &out.place_error, &out.rate_error, &out.acceleration,
                           &out.stiffness_1_s2, &out.damping_1_s, &out.weight}) {
    column->conservativeResize(row);
  }
}

}  // namespace torquewright::hopper
