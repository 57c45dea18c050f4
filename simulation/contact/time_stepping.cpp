// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/time_stepping.md.
#include "simulation/contact/time_stepping.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "dynamics/passive_forces.hpp"
#include "dynamics/position_step.hpp"

namespace torquewright::simulation {

using dynamics::VectorIn;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// How much of what soft ground gives along its normal it creeps under friction: points of one foot
/// that are sunk to different depths would else hold each other with all that friction allows.
constexpr double kCreepShare = 0.01;

/// No robot is so far away or so fast.
bool is_sound(const VectorXd& numbers) {
  constexpr double kMost = 1e10;
  return numbers.allFinite() && numbers.cwiseAbs().maxCoeff() < kMost;
}

VectorXd damping_of(const dynamics::Tree& tree) {
  VectorXd damping = VectorXd::Zero(tree.velocity_size());
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    damping[tree.base_velocity_size() + static_cast<Index>(i) - 1] =
        tree.bodies[i].joint.passive.damping;
  }
  return damping;
}

}  // namespace

TimeStepping::TimeStepping(MovingBodies& bodies, Obstacles obstacles)
    : bodies_(bodies), obstacles_(std::move(obstacles)) {
  const Index size = bodies.state().velocity().size();
  impulses_N_s_.resize(3 * static_cast<Index>(obstacles_.points.size()));
  stop_impulses_.resize(static_cast<Index>(obstacles_.stops.size()));
  friction_impulses_.resize(static_cast<Index>(obstacles_.frictions.size()));
  damping_ = damping_of(bodies.state().tree());
  has_drag_ = !obstacles_.frictions.empty() || !damping_.isZero(0.0);
  generalised_.resize(size);
  jump_.resize(size);
  for (Stage& stage : stages_) stage.rate.resize(size);
  bias_.resize(size);
  mass_.resize(size, size);
  jacobian_.resize(3, size);
  met_by_count_.resize(obstacles_.points.size() + obstacles_.stops.size() +
                       obstacles_.frictions.size() + 1);
  active_.reserve(obstacles_.points.size());
  sunk_m_.reserve(obstacles_.points.size());
  active_stops_.reserve(obstacles_.stops.size());
  gives_back_ = obstacles_.time_constant_s == 0.0 &&
                std::any_of(obstacles_.points.begin(), obstacles_.points.end(),
                            [](const GroundPoint& point) { return point.restitution > 0.0; });
  forget();
}

void TimeStepping::forget() {
  flew_ = false;
  active_.clear();
  active_stops_.clear();
  count_ = 0;
  impulses_N_s_.setZero();
  stop_impulses_.setZero();
  friction_impulses_.setZero();
  generalised_.setZero();
  jump_.setZero();
}

TimeStepping::Outcome TimeStepping::step(VectorXd& position, VectorXd& velocity,
                                         const VectorIn& force, double step_s) {
  const dynamics::Tree& tree = bodies_.state().tree();
  if (position.size() != tree.position_size() || velocity.size() != jump_.size() ||
      force.size() != jump_.size()) {
    throw std::invalid_argument("time stepping: wrong number of positions, velocities or forces");
  }
  position_ = position;
  velocity_ = velocity;
  move(position_, velocity_, 0.5 * step_s, middle_);
  // What flew is likely to fly on: then its second stage stands in the middle and shows whether
  // something touches.
  bool touches = !flew_;
  Outcome outcome = Outcome::kStepped;
  if (!touches) {
    outcome = fly(force, step_s, touches);
    touches = touches || outcome != Outcome::kStepped;
  }
  if (touches) {
    outcome = place(middle_, velocity_);
    if (outcome != Outcome::kStepped) return outcome;
    find_active();
    touches = is_active();
    outcome = touches ? touch(force, step_s) : fly(force, step_s, touches);
  }
  if (outcome != Outcome::kStepped) return outcome;
  if (!is_sound(position_) || !is_sound(velocity_)) return Outcome::kBlownUp;
  record_impulses();
  flew_ = !touches;
  position = position_;
  velocity = velocity_;
  return outcome;
}

void TimeStepping::move(const VectorXd& position, const VectorXd& velocity, double duration_s,
                        VectorXd& out) const {
  out.resize(position.size());
  dynamics::step_position(bodies_.state().tree(), position, velocity, duration_s, out);
}

TimeStepping::Outcome TimeStepping::place(const VectorXd& position, const VectorXd& velocity) {
  if (!position.allFinite() || !velocity.allFinite()) return Outcome::kBlownUp;
  return bodies_.set(position, velocity) ? Outcome::kStepped : Outcome::kUnreached;
}

void TimeStepping::find_active() {
  const dynamics::TreeState& state = bodies_.state();
  active_.clear();
  sunk_m_.clear();
  for (std::size_t i = 0; i < obstacles_.points.size(); ++i) {
    const GroundPoint& point = obstacles_.points[i];
    const Eigen::Vector3d place_m = dynamics::point_position_m(state, point.point);
    const double ground_m = obstacles_.ground_height_m + obstacles_.profile.height_m(place_m.x());
    const double above_m = place_m.z() - point.radius_m - ground_m;
    if (above_m > 0.0) continue;
    active_.push_back(i);
    sunk_m_.push_back(-above_m);
  }
  active_stops_.clear();
  const Index extra = middle_.size() - jump_.size();
  for (std::size_t i = 0; i < obstacles_.stops.size(); ++i) {
    const JointStop& stop = obstacles_.stops[i];
    if (stop.inward * (middle_[stop.row + extra] - stop.bound) <= 0.0) active_stops_.push_back(i);
  }
}

/// With dampers that feel how the velocity changes over `implicit_s`; eq. (11).
TimeStepping::Outcome TimeStepping::accelerations(const VectorIn& force, double implicit_s,
                                                  VectorXd& out) {
  bodies_.mass_matrix(mass_);
  if (has_drag_) {
    stiff_ = implicit_s * damping_ - mass_.diagonal();
    mass_.diagonal() += (0.5 * implicit_s * damping_).cwiseMax(stiff_);
  }
  bodies_.bias(bias_);
  factors_.compute(mass_);
  if (factors_.info() != Eigen::Success) return Outcome::kBlownUp;
  out = force - bias_;
  factors_.solveInPlace(out);
  return Outcome::kStepped;
}

/// The stage that the acceleration and rate of the one before lead to.
void TimeStepping::lead(const Stage& before, double duration_s, Stage& next) {
  next.step = duration_s * before.rate;
  next.velocity = velocity_ + duration_s * before.acceleration;
  dynamics::step_rate(bodies_.state().tree(), next.step, next.velocity, next.rate);
}

// eqs. (1), (2)
TimeStepping::Outcome TimeStepping::fly(const VectorIn& force, double step_s, bool& touches) {
  stages_[0].velocity = stages_[0].rate = velocity_;
  stage_position_ = position_;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    const double duration_s = i == 0 ? 0.0 : i < 3 ? 0.5 * step_s : step_s;
    if (i > 0) {
      lead(stages_[i - 1], duration_s, stages_[i]);
      move(position_, stages_[i - 1].rate, duration_s, stage_position_);
    }
    Outcome outcome = place(stage_position_, stages_[i].velocity);
    if (outcome != Outcome::kStepped) return outcome;
    if (i == 1) {  // in the middle
      find_active();
      touches = is_active();
      if (touches) return outcome;
    }
    outcome = accelerations(force, 0.0, stages_[i].acceleration);
    if (outcome != Outcome::kStepped) return outcome;
  }
  const auto& [one, two, three, four] = stages_;
  rate_ = (one.rate + 2.0 * two.rate + 2.0 * three.rate + four.rate) / 6.0;
  stage_position_ = position_;
  move(stage_position_, rate_, step_s, position_);
  velocity_ +=
      step_s / 6.0 *
      (one.acceleration + 2.0 * two.acceleration + 2.0 * three.acceleration + four.acceleration);
  return Outcome::kStepped;
}

// eq. (3)
TimeStepping::Outcome TimeStepping::touch(const VectorIn& force, double step_s) {
  const Outcome outcome = accelerations(force, step_s, acceleration_);
  if (outcome != Outcome::kStepped) return outcome;
  free_velocity_ = velocity_ + step_s * acceleration_;
  if (!free_velocity_.allFinite()) return Outcome::kBlownUp;
  if (!solve_active(step_s)) return Outcome::kUnsolved;
  if (met().impulses.size() == 0) {  // dampers alone
    generalised_.setZero();
    jump_.setZero();
  } else {
    generalised_.noalias() = met().directions * met().impulses;
    jump_.noalias() = met().answers * met().impulses;
    factors_.matrixU().solveInPlace(jump_);
  }
  velocity_ = free_velocity_ + jump_;
  move(middle_, velocity_, 0.5 * step_s, position_);
  return Outcome::kStepped;
}

void TimeStepping::record_impulses() {
  impulses_N_s_.setZero();
  stop_impulses_.setZero();
  friction_impulses_.setZero();
  if (!is_active()) {
    generalised_.setZero();
    jump_.setZero();
    return;
  }
  Index row = 0;
  for (const std::size_t point : active_) {
    impulses_N_s_.segment<3>(3 * static_cast<Index>(point)) = met().impulses.segment<3>(row);
    row += 3;
  }
  for (const std::size_t stop : active_stops_) {
    stop_impulses_[static_cast<Index>(stop)] = met().impulses[row + 2];
    row += 3;
  }
  for (Index i = 0; i < friction_impulses_.size(); ++i) {
    friction_impulses_[i] = met().impulses[row + 3 * i];
  }
}

void TimeStepping::generalised_impulse_of(std::size_t points, dynamics::VectorOut out) const {
  const auto count = std::count_if(active_.begin(), active_.end(),
                                   [&](std::size_t point) { return point < points; });
  const Index rows = 3 * static_cast<Index>(count);
  out.setZero();
  if (rows > 0) out.noalias() += met().directions.leftCols(rows) * met().impulses.head(rows);
}

/// The velocities at what is met; of the restitution only that share; eqs. (4), (7).
void TimeStepping::gather(double restitution_share, double step_s) {
  met().problem.free_m_s.noalias() = met().directions.transpose() * free_velocity_;
  answer_by_friction(step_s);
  if (!gives_back_) return;
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const Index normal = 3 * static_cast<Index>(k) + 2;
    const double before_m_s = met().directions.col(normal).dot(velocity_);
    met().problem.free_m_s[normal] +=
        restitution_share * obstacles_.points[active_[k]].restitution * std::min(0.0, before_m_s);
  }
}

/// A joint's friction is a point that slides along the joint under a force of its own, which
/// nothing else feels: its second and third rows answer to themselves alone, the third such that
/// the impulse there is the friction's limit; eq. (12).
void TimeStepping::answer_by_friction(double step_s) {
  for (std::size_t i = 0; i < obstacles_.frictions.size(); ++i) {
    const JointFriction& friction = obstacles_.frictions[i];
    const Index row = first_friction_row() + 3 * static_cast<Index>(i);
    const bool rests = std::abs(met().directions.col(row).dot(velocity_)) <= dynamics::kRest;
    const double response_1_kg = met().problem.response_1_kg(row, row);
    met().problem.response_1_kg.diagonal().segment<2>(row + 1).setConstant(response_1_kg);
    met().problem.free_m_s[row + 2] =
        -response_1_kg * step_s * (rests ? friction.resting : friction.moving);
  }
}

/// Impulses times the mean of the velocities before and after; rounding aside.
double TimeStepping::contact_work_J() const {
  const Index rows = first_friction_row();
  double work_J = 0.0, size_J = 0.0;
  for (Index row = 0; row < rows; ++row) {
    const double before_m_s = met().directions.col(row).dot(free_velocity_);
    const double change_m_s = met().problem.response_1_kg.col(row).dot(met().impulses);
    const double impulse = met().impulses[row];
    work_J += impulse * (before_m_s + 0.5 * change_m_s);
    size_J += std::abs(impulse * before_m_s);
  }
  return work_J - 1e-14 * size_J;
}

/// Jacobians, friction, and the last step's impulses, which are near.
void TimeStepping::fill_rows() {
  const auto count = first_friction_row() / 3 + friction_impulses_.size();
  count_ = static_cast<std::size_t>(count);
  met().directions.setZero(jump_.size(), 3 * count);
  met().problem.friction_coefficients.setZero(count);
  met().impulses.setZero(3 * count);
  Index k = 0;
  for (const std::size_t index : active_) {
    const GroundPoint& point = obstacles_.points[index];
    dynamics::point_jacobian(bodies_.state(), lowest_point(bodies_.state(), point), jacobian_);
    met().directions.middleCols<3>(3 * k) = jacobian_.transpose();
    met().problem.friction_coefficients[k] = point.friction_coefficient;
    met().impulses.segment<3>(3 * k) = impulses_N_s_.segment<3>(3 * static_cast<Index>(index));
    ++k;
  }
  for (const std::size_t index : active_stops_) {
    met().directions(obstacles_.stops[index].row, 3 * k + 2) = obstacles_.stops[index].inward;
    met().impulses[3 * k + 2] = stop_impulses_[static_cast<Index>(index)];
    ++k;
  }
  fill_friction_rows();
}

void TimeStepping::fill_friction_rows() {
  for (std::size_t i = 0; i < obstacles_.frictions.size(); ++i) {
    const Index row = first_friction_row() + 3 * static_cast<Index>(i);
    bodies_.joint_motion(obstacles_.frictions[i].row, met().directions.col(row));
    met().problem.friction_coefficients[row / 3] = 1.0;
    met().impulses[row] = friction_impulses_[static_cast<Index>(i)];
  }
}

/// W = J M^-1 J^T from L^-1 J^T, where M = L L^T. Columns are short: plain loops are faster than
/// products in blocks.
void TimeStepping::respond() {
  const Index size = met().directions.rows(), columns = met().directions.cols();
  met().answers = met().directions;
  const auto& L = factors_.matrixLLT();
  for (Index k = 0; k < columns; ++k) {
    auto column = met().answers.col(k);
    for (Index i = 0; i < size; ++i) {
      if (column[i] == 0.0) continue;
      column[i] /= L(i, i);
      const Index below = size - i - 1;
      column.tail(below) -= column[i] * L.col(i).tail(below);
    }
  }
  met().problem.response_1_kg.resize(columns, columns);
  for (Index k = 0; k < columns; ++k) {
    for (Index j = 0; j <= k; ++j) {
      const double response_1_kg = met().answers.col(j).dot(met().answers.col(k));
      met().problem.response_1_kg(j, k) = met().problem.response_1_kg(k, j) = response_1_kg;
    }
  }
}

/// What gives moves by its impulse alone, and back by how deep it is; eq. (8a).
void TimeStepping::soften(double step_s) {
  const double constant_s = obstacles_.time_constant_s;
  const double lasts_s = 0.5 * step_s + 2.0 * constant_s;
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const Index first = 3 * static_cast<Index>(k), normal = first + 2;
    const double gives_1_kg =
        met().problem.response_1_kg(normal, normal) * constant_s * constant_s / (step_s * lasts_s);
    met().problem.response_1_kg.diagonal().segment<2>(first).array() += kCreepShare * gives_1_kg;
    met().problem.response_1_kg(normal, normal) += gives_1_kg;
    met().problem.free_m_s[normal] -= sunk_m_[k] / lasts_s;
  }
}

bool TimeStepping::solve_active(double step_s) {
  fill_rows();
  if (met().impulses.size() == 0) return true;
  respond();
  constexpr double kShares[] = {1.0, 0.75, 0.5, 0.25, 0.0};
  for (const double share : kShares) {
    gather(share, step_s);
    if (obstacles_.time_constant_s > 0.0) soften(step_s);
    const bool is_solved = solve_contacts(met().problem, met().newton, met().impulses);
    if (!gives_back_ || share == 0.0) return is_solved;
    if (is_solved && contact_work_J() <= 0.0) break;  // eq. (8)
  }
  return true;
}

}  // namespace torquewright::simulation
