// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/time_stepping.md.
#include "simulation/contact/time_stepping.hpp"

#include <algorithm>
#include <utility>

#include "dynamics/position_step.hpp"

namespace torquewright::simulation {
namespace {

using dynamics::VectorIn;
using Eigen::Index;
using Eigen::VectorXd;

VectorXd moved(const dynamics::Tree& tree, const VectorXd& position, const VectorXd& velocity,
               double duration_s) {
  VectorXd result(position.size());
  dynamics::step_position(tree, position, velocity, duration_s, result);
  return result;
}

}  // namespace

TimeStepping::TimeStepping(MovingBodies& bodies, std::vector<GroundPoint> points,
                           double ground_height_m)
    : bodies_(bodies), points_(std::move(points)), ground_height_m_(ground_height_m) {
  const Index size = bodies.state().velocity().size();
  impulses_N_s_ = VectorXd::Zero(3 * static_cast<Index>(points_.size()));
  generalised_ = VectorXd::Zero(size);
  jump_ = VectorXd::Zero(size);
  bias_.resize(size);
  mass_.resize(size, size);
}

TimeStepping::Outcome TimeStepping::step(VectorXd& position, VectorXd& velocity,
                                         const VectorIn& force, double step_s) {
  const dynamics::Tree& tree = bodies_.state().tree();
  position_ = position;
  velocity_ = velocity;
  middle_ = moved(tree, position_, velocity_, 0.5 * step_s);
  if (!middle_.allFinite() || !velocity_.allFinite()) return Outcome::kBlownUp;
  if (!bodies_.set(middle_, velocity_)) return Outcome::kUnreached;
  find_active();
  const Outcome outcome = active_.empty() ? fly(force, step_s) : touch(force, step_s);
  if (outcome != Outcome::kStepped) return outcome;
  if (!position_.allFinite() || !velocity_.allFinite()) return Outcome::kBlownUp;
  position = position_;
  velocity = velocity_;
  return outcome;
}

void TimeStepping::find_active() {
  active_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double height_m = dynamics::point_position_m(bodies_.state(), points_[i].point).z();
    if (height_m <= ground_height_m_) active_.push_back(i);
  }
}

bool TimeStepping::accelerations(const VectorIn& position, const VectorIn& velocity,
                                 const VectorIn& force, VectorXd& out, Outcome& trouble) {
  trouble = Outcome::kBlownUp;
  if (!position.allFinite() || !velocity.allFinite()) return false;
  trouble = Outcome::kUnreached;
  if (!bodies_.set(position, velocity)) return false;
  trouble = Outcome::kBlownUp;
  bodies_.mass_matrix(mass_);
  bodies_.bias(bias_);
  factors_.compute(mass_);
  if (factors_.info() != Eigen::Success) return false;
  out = factors_.solve(force - bias_);
  return true;
}

// eqs. (1), (2)
TimeStepping::Outcome TimeStepping::fly(const VectorIn& force, double step_s) {
  impulses_N_s_.setZero();
  generalised_.setZero();
  jump_.setZero();
  const dynamics::Tree& tree = bodies_.state().tree();
  const VectorXd q = position_, v = velocity_;
  VectorXd v_2, v_3, v_4, a_1, a_2, a_3, a_4;
  Outcome trouble;
  if (!accelerations(q, v, force, a_1, trouble)) return trouble;
  v_2 = v + 0.5 * step_s * a_1;
  if (!accelerations(moved(tree, q, v, 0.5 * step_s), v_2, force, a_2, trouble)) return trouble;
  v_3 = v + 0.5 * step_s * a_2;
  if (!accelerations(moved(tree, q, v_2, 0.5 * step_s), v_3, force, a_3, trouble)) return trouble;
  v_4 = v + step_s * a_3;
  if (!accelerations(moved(tree, q, v_3, step_s), v_4, force, a_4, trouble)) return trouble;
  position_ = moved(tree, q, (v + 2.0 * v_2 + 2.0 * v_3 + v_4) / 6.0, step_s);
  velocity_ = v + step_s / 6.0 * (a_1 + 2.0 * a_2 + 2.0 * a_3 + a_4);
  return Outcome::kStepped;
}

// eq. (3)
TimeStepping::Outcome TimeStepping::touch(const VectorIn& force, double step_s) {
  VectorXd acceleration;
  Outcome trouble;
  if (!accelerations(middle_, velocity_, force, acceleration, trouble)) return trouble;
  free_velocity_ = velocity_ + step_s * acceleration;
  if (!free_velocity_.allFinite()) return Outcome::kBlownUp;
  if (!solve_active()) return Outcome::kUnsolved;
  generalised_ = jacobian_.transpose() * active_impulses_;
  jump_ = jacobian_answer_ * active_impulses_;
  velocity_ = free_velocity_ + jump_;
  position_ = moved(bodies_.state().tree(), middle_, velocity_, 0.5 * step_s);
  impulses_N_s_.setZero();
  for (std::size_t k = 0; k < active_.size(); ++k) {
    impulses_N_s_.segment<3>(3 * static_cast<Index>(active_[k])) =
        active_impulses_.segment<3>(3 * static_cast<Index>(k));
  }
  return Outcome::kStepped;
}

/// The contacts' velocities; of the restitution only that share; eqs. (4), (7).
void TimeStepping::gather(double restitution_share) {
  problem_.free_m_s = jacobian_ * free_velocity_;
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const Index normal = 3 * static_cast<Index>(k) + 2;
    const double before_m_s = jacobian_.row(normal).dot(velocity_);
    problem_.free_m_s[normal] +=
        restitution_share * points_[active_[k]].restitution * std::min(0.0, before_m_s);
  }
}

/// Impulses times the mean of the velocities before and after; rounding aside.
double TimeStepping::contact_work_J() const {
  const VectorXd before_m_s = jacobian_ * free_velocity_;
  const VectorXd change_m_s = problem_.response_1_kg * active_impulses_;
  const double rounding_J = 1e-14 * active_impulses_.cwiseAbs().dot(before_m_s.cwiseAbs());
  return active_impulses_.dot(before_m_s + 0.5 * change_m_s) - rounding_J;
}

bool TimeStepping::solve_active() {
  const Index points = static_cast<Index>(active_.size());
  jacobian_.resize(3 * points, velocity_.size());
  problem_.friction_coefficients.resize(points);
  active_impulses_.resize(3 * points);
  for (Index k = 0; k < points; ++k) {
    const std::size_t point = active_[static_cast<std::size_t>(k)];
    dynamics::point_jacobian(bodies_.state(), points_[point].point, jacobian_.middleRows<3>(3 * k));
    problem_.friction_coefficients[k] = points_[point].friction_coefficient;
    active_impulses_.segment<3>(3 * k) =
        impulses_N_s_.segment<3>(3 * static_cast<Index>(point));  // the last step's are near
  }
  jacobian_answer_ = factors_.solve(jacobian_.transpose());
  problem_.response_1_kg = jacobian_ * jacobian_answer_;
  constexpr double kShares[] = {1.0, 0.75, 0.5, 0.25, 0.0};
  for (const double share : kShares) {
    gather(share);
    if (!solve_contacts(problem_, active_impulses_)) return false;
    if (contact_work_J() <= 0.0) break;  // eq. (8)
  }
  return true;
}

}  // namespace torquewright::simulation
