// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/operational/torque_program.hpp"

#include <limits>
#include <numbers>

#include "hopper/tracking/drive_loops.hpp"
#include "hopper/tracking/linearisation.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// Rows of a contact's pyramid: four sides and the ground, which does not pull.
constexpr Index kSides = 5;

double whole_mass_kg(const Robot& robot) {
  double sum_kg = robot.links_kg();
  for (const dynamics::Body& body : robot.tree.bodies) sum_kg += body.inertia.mass_kg;
  return sum_kg;
}

}  // namespace

TorqueProgram::TorqueProgram(const Robot& robot, const OperationalTasks& tasks)
    : robot_(robot),
      tasks_(tasks),
      peaks_Nm_(peak_torques_Nm(robot)),
      weight_N_(whole_mass_kg(robot) * robot.tree.gravity_m_s2) {}

optimization::QuadraticStatus TorqueProgram::solve(TaskFrame& frame, const TaskRows& rows,
                                                   const VectorXd& wanted,
                                                   const TouchingPoints& touches,
                                                   const TorqueBounds& bounds) {
  move(frame);
  price(frame, rows, wanted);
  bound(touches, bounds);
  solution_ = &solver_.solve(program_);
  const VectorXd scaled = scales_.cwiseProduct(solution_->x);
  torque_Nm_ = scaled.head(peaks_Nm_.size());
  contact_N_.setZero(3 * touches.size());
  for (Index point = 0, at = peaks_Nm_.size(); point < touches.size(); ++point) {
    if (!touches[point]) continue;
    contact_N_.segment<3>(3 * point) = scaled.segment<3>(at);
    at += 3;
  }
  acceleration_ = free_ + effect_ * solution_->x;
  return solution_->status;
}

/// Accelerations are affine in the unknowns, eq. (5).
void TorqueProgram::move(TaskFrame& frame) {
  const MatrixXd& points = frame.contacts().jacobian;
  const MatrixXd& springs = frame.springs();
  const Index drives = peaks_Nm_.size(), forces = points.rows();
  const Index unknowns = drives + forces + springs.rows();
  scales_.resize(unknowns);
  scales_.head(drives) = peaks_Nm_;
  scales_.segment(drives, forces).setConstant(weight_N_);
  // A spring's force at a lever of 0.1 m, as a scale alone.
  scales_.tail(springs.rows()).setConstant(0.1 * weight_N_);
  MatrixXd on_velocities(frame.velocity().size(), unknowns);
  on_velocities << drive_jacobian(frame.body()).transpose(), points.transpose(),
      springs.transpose();
  mass_.compute(frame.mass());
  effect_ = mass_.solve(on_velocities * scales_.asDiagonal());
  free_ = -mass_.solve(frame.bias_force());
}

/// Adds the weighted squares of rows x + off.
void TorqueProgram::add_square(const MatrixXd& rows, const VectorXd& off, const VectorXd& weight) {
  const MatrixXd weighted = weight.asDiagonal() * rows;
  program_.cost.noalias() += rows.transpose() * weighted;
  program_.slope.noalias() += weighted.transpose() * off;
}

/// Eq. (6).
void TorqueProgram::price(TaskFrame& frame, const TaskRows& rows, const VectorXd& wanted) {
  const VectorXd& velocity = frame.velocity();
  const Index unknowns = scales_.size();
  program_.cost.setZero(unknowns, unknowns);
  program_.slope.setZero(unknowns);
  program_.cost.diagonal().setConstant(tasks_.effort_weight * tasks_.effort_weight);
  add_square(rows.jacobian * effect_, rows.jacobian * free_ + rows.bias - wanted, rows.weight);
  const MatrixXd& points = frame.contacts().jacobian;
  const VectorXd moving = frame.contacts().bias_m_s2 + points * velocity / tasks_.contact_time_s;
  add_square(points * effect_, points * free_ + moving,
             VectorXd::Constant(points.rows(), tasks_.contact_weight));
  const MatrixXd& held = frame.springs();
  const Index springs = held.rows(), others = kSides * points.rows() / 3 + peaks_Nm_.size();
  program_.rows.setZero(springs + others, unknowns);
  program_.lower.setConstant(springs + others, -kUnbounded);
  program_.upper.setConstant(springs + others, kUnbounded);
  // Rigid springs do not begin to turn; that they turn at all is not seen.
  program_.rows.topRows(springs) = held * effect_;
  program_.lower.head(springs) = -held * free_;
  program_.upper.head(springs) = program_.lower.head(springs);
}

/// Eqs. (7) and (8).
void TorqueProgram::bound(const TouchingPoints& touches, const TorqueBounds& bounds) {
  const Index drives = peaks_Nm_.size();
  Index row = static_cast<Index>(tasks_.rigid.size());
  program_.rows.block(row, 0, drives, drives).setIdentity();
  program_.lower.segment(row, drives) = bounds.least_Nm.cwiseQuotient(peaks_Nm_);
  program_.upper.segment(row, drives) = bounds.greatest_Nm.cwiseQuotient(peaks_Nm_);
  row += drives;
  for (Index point = 0, at = drives; point < touches.size(); ++point) {
    if (!touches[point]) continue;
    const double friction = robot_.contacts[static_cast<std::size_t>(point)].friction_coefficient *
                            tasks_.friction_share / std::numbers::sqrt2;
    for (Index side = 0; side < 4; ++side) {
      program_.rows(row + side, at + side / 2) = side % 2 == 0 ? 1.0 : -1.0;
      program_.rows(row + side, at + 2) = -friction;
      program_.upper[row + side] = 0.0;
    }
    program_.rows(row + 4, at + 2) = 1.0;
    program_.lower[row + 4] = 0.0;
    row += kSides;
    at += 3;
  }
}

}  // namespace torquewright::hopper
