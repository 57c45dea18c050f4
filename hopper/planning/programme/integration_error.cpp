// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/integration_error.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/planning/model/laws.hpp"
#include "hopper/planning/plane/planned_instant.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Position and velocity of what moves.
struct State {
  VectorXd position;
  VectorXd velocity;
};

/// Accelerations and what the ground gives are the unknowns of one linear system: the equations of
/// motion, and that what touches does not accelerate.
class Forward {
 public:
  Forward(const SagittalRobot& robot, const Stance& stance)
      : stance_(stance),
        dynamics_(robot),
        moving_(robot.moving_count()),
        forces_(static_cast<Index>(stance.force_count())) {}

  /// Accelerations under torques at the drives; not finite where there are none.
  VectorXd operator()(const State& at, const VectorXd& drive_Nm) {
    if (!at.position.allFinite() || !at.velocity.allFinite()) {
      return VectorXd::Constant(moving_, std::numeric_limits<double>::quiet_NaN());
    }
    dynamics_.set(stance_.frame(), at.position, at.velocity);
    const Index size = moving_ + forces_;
    const VectorXd rest = rows(VectorXd::Zero(size), drive_Nm);
    Eigen::MatrixXd columns(size, size);
    for (Index i = 0; i < size; ++i) {
      columns.col(i) = rows(VectorXd::Unit(size, i), drive_Nm) - rest;
    }
    return columns.partialPivLu().solve(-rest).head(moving_);
  }

  /// The part of the frame's moment that no force at the points on the ground explains.
  double unexplained_Nm(const State& at, const VectorXd& acceleration, const VectorXd& drive_Nm) {
    constexpr Index kOnOnePoint = 2;
    if (forces_ > kOnOnePoint) return 0.0;
    dynamics_.set(stance_.frame(), at.position, at.velocity);
    const auto frame_rows = [&](const VectorXd& forces) {
      return dynamics_.residual(acceleration, drive_Nm, forces_of(stance_, forces, 0))
          .head<3>()
          .eval();
    };
    const Eigen::Vector3d rest = frame_rows(VectorXd::Zero(forces_));
    if (forces_ == 0) return rest[2];
    Eigen::Matrix<double, 3, 2> columns;
    for (Index i = 0; i < kOnOnePoint; ++i) {
      columns.col(i) = frame_rows(VectorXd::Unit(forces_, i)) - rest;
    }
    const Eigen::Vector2d forces = columns.topRows<2>().partialPivLu().solve(-rest.head<2>());
    return rest[2] + columns.row(2).dot(forces);
  }

 private:
  VectorXd rows(const VectorXd& unknowns, const VectorXd& drive_Nm) {
    const VectorXd acceleration = unknowns.head(moving_);
    VectorXd held(forces_);
    stance_rows<double>(
        dynamics_.robot(), stance_,
        [&](const dynamics::BodyPoint& point) {
          return dynamics_.acceleration_m_s2(point, acceleration);
        },
        held);
    VectorXd out(moving_ + forces_);
    out << dynamics_.residual(acceleration, drive_Nm, forces_of(stance_, unknowns, moving_))
               .head(moving_),
        held;
    return out;
  }

  Stance stance_;
  SagittalDynamicsOf<double> dynamics_;
  Index moving_;
  Index forces_;
};

State advance(const State& from, double h, const VectorXd& rate, const VectorXd& second) {
  return {from.position + h * rate, from.velocity + h * second};
}

class Integrator {
 public:
  Integrator(const SagittalRobot& robot, const Stance& stance, const PlannedPhase& phase, int steps)
      : robot_(robot), phase_(phase), steps_(steps), forward_(robot, stance) {}

  State begin(std::size_t interval) const {
    const PlannedInstant& at = phase_.instants[2 * interval];
    return {moving(at.position), moving(at.velocity)};
  }
  State over(std::size_t interval, State state) {
    const double h = length_s(interval) / steps_;
    for (int i = 0; i < steps_; ++i) {
      const double s = static_cast<double>(i) / steps_;
      const VectorXd u0 = torques(interval, s);
      const VectorXd um = torques(interval, s + 0.5 / steps_);
      const VectorXd u1 = torques(interval, s + 1.0 / steps_);
      const VectorXd a1 = forward_(state, u0);
      const State s2 = advance(state, 0.5 * h, state.velocity, a1);
      const VectorXd a2 = forward_(s2, um);
      const State s3 = advance(state, 0.5 * h, s2.velocity, a2);
      const VectorXd a3 = forward_(s3, um);
      const State s4 = advance(state, h, s3.velocity, a3);
      const VectorXd a4 = forward_(s4, u1);
      state = advance(state, h / 6.0,
                      state.velocity + 2.0 * s2.velocity + 2.0 * s3.velocity + s4.velocity,
                      a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    return state;
  }
  double unexplained_Nm(std::size_t interval) {
    double greatest = 0.0;
    for (const double share : {0.25, 0.75}) {
      const PlannedInstant at = instant_within(phase_, interval, share);
      greatest = std::max(
          greatest, std::abs(forward_.unexplained_Nm({moving(at.position), moving(at.velocity)},
                                                     moving(at.acceleration), at.drive_Nm)));
    }
    return greatest;
  }
  double length_s(std::size_t interval) const {
    return phase_.instants[2 * interval + 2].time_s - phase_.instants[2 * interval].time_s;
  }
  /// Of angles: the frame's pitch and joints.
  double apart_rad(const VectorXd& a, const VectorXd& b) const {
    const double most = (a - b).tail(a.size() - 2).cwiseAbs().maxCoeff();
    return std::isfinite(most) ? most : std::numeric_limits<double>::infinity();
  }

 private:
  VectorXd moving(const VectorXd& rows) const {
    VectorXd out(robot_.moving_count());
    for (Index i = 0; i < out.size(); ++i) {
      out[i] = rows[robot_.moving[static_cast<std::size_t>(i)]];
    }
    return out;
  }
  VectorXd torques(std::size_t interval, double s) const {
    const VectorXd& u0 = phase_.instants[2 * interval].drive_Nm;
    const VectorXd& um = phase_.instants[2 * interval + 1].drive_Nm;
    const VectorXd& u1 = phase_.instants[2 * interval + 2].drive_Nm;
    return u0 + s * (-3.0 * u0 + 4.0 * um - u1) + s * s * (2.0 * u0 - 4.0 * um + 2.0 * u1);
  }

  const SagittalRobot& robot_;
  const PlannedPhase& phase_;
  int steps_;
  Forward forward_;
};

PhaseError error_of(const SagittalRobot& robot, const Stance& stance, const PlannedPhase& phase,
                    int steps) {
  Integrator integrator(robot, stance, phase, steps);
  PhaseError error;
  State whole = integrator.begin(0);
  for (std::size_t i = 0; i < phase.intervals(); ++i) {
    const State planned = integrator.begin(i + 1);
    const State anew = integrator.over(i, integrator.begin(i));
    error.interval_rad.push_back(
        std::max(integrator.apart_rad(anew.position, planned.position),
                 integrator.length_s(i) * integrator.apart_rad(anew.velocity, planned.velocity)));
    error.unexplained_Nm.push_back(integrator.unexplained_Nm(i));
    whole = integrator.over(i, whole);
    error.whole_rad =
        std::max(error.whole_rad, integrator.apart_rad(whole.position, planned.position));
  }
  return error;
}

}  // namespace

double PhaseError::greatest_unexplained_Nm() const {
  return *std::max_element(unexplained_Nm.begin(), unexplained_Nm.end());
}

std::vector<PhaseError> integration_errors(const SagittalRobot& robot,
                                           const std::vector<Stance>& stances,
                                           const PlannedMotion& plan, int steps) {
  std::vector<PhaseError> out;
  for (std::size_t p = 0; p < plan.phases.size(); ++p) {
    out.push_back(error_of(robot, stances[p], plan.phases[p], steps));
  }
  return out;
}

}  // namespace torquewright::hopper
