// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/time_stepping.md.
#include "simulation/contact/contact_newton.hpp"

#include <algorithm>

namespace torquewright::simulation {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Impulse over velocity, about that of the point itself.
double scale_kg(const ContactProblem& problem, Index k) {
  return 3.0 / problem.response_1_kg.diagonal().segment<3>(3 * k).sum();
}

/// How far the impulses in memory are from their laws, as velocities, and what a change of them
/// does to that; eqs. (9), (10).
class Projections {
 public:
  Projections(const ContactProblem& problem, NewtonMemory& memory)
      : problem_(problem),
        impulse_(memory.impulse_N_s),
        velocity_(memory.velocity_m_s),
        off_m_s_(memory.off_m_s),
        slope_1_kg_(memory.slope_1_kg) {}

  void linearise() {
    const Index size = impulse_.size();
    velocity_.noalias() = problem_.response_1_kg * impulse_;
    velocity_ += problem_.free_m_s;
    off_m_s_.resize(size);
    slope_1_kg_.setZero(size, size);
    for (Index k = 0; k < size / 3; ++k) {
      const double scale = scale_kg(problem_, k);
      if (impulse_[3 * k + 2] - scale * velocity_[3 * k + 2] <= 0.0) {
        off_m_s_.segment<3>(3 * k) = impulse_.segment<3>(3 * k) / scale;
        slope_1_kg_.block<3, 3>(3 * k, 3 * k).diagonal().setConstant(1.0 / scale);
      } else {
        press(k, scale);
      }
    }
  }

 private:
  void press(Index k, double scale) {
    const MatrixXd& W = problem_.response_1_kg;
    off_m_s_[3 * k + 2] = velocity_[3 * k + 2];
    slope_1_kg_.row(3 * k + 2) = W.row(3 * k + 2);
    const double mu = problem_.friction_coefficients[k];
    const double radius = mu * (impulse_[3 * k + 2] - scale * velocity_[3 * k + 2]);
    const Vector2d aim = impulse_.segment<2>(3 * k) - scale * velocity_.segment<2>(3 * k);
    const double length = aim.norm();
    if (length <= radius) {  // sticks
      off_m_s_.segment<2>(3 * k) = velocity_.segment<2>(3 * k);
      slope_1_kg_.middleRows<2>(3 * k) = W.middleRows<2>(3 * k);
      return;
    }
    const Vector2d along = aim / length;
    off_m_s_.segment<2>(3 * k) = (impulse_.segment<2>(3 * k) - radius * along) / scale;
    const Matrix2d turning = radius / length * (Matrix2d::Identity() - along * along.transpose());
    auto rows = slope_1_kg_.middleRows<2>(3 * k);
    for (Index i = 0; i < rows.cols(); ++i) {
      const Vector2d sliding = W.block<2, 1>(3 * k, i);
      rows.col(i) = turning * sliding + mu * W(3 * k + 2, i) * along;
    }
    rows.middleCols<2>(3 * k) += (Matrix2d::Identity() - turning) / scale;
    rows.col(3 * k + 2) -= mu / scale * along;
  }

  const ContactProblem& problem_;
  const VectorXd& impulse_;
  VectorXd& velocity_;
  VectorXd& off_m_s_;
  MatrixXd& slope_1_kg_;
};

}  // namespace

bool newton_contacts(const ContactProblem& problem, double tolerance_m_s, NewtonMemory& memory,
                     VectorXd& impulse_N_s) {
  constexpr int kMostSteps = 30;
  const double most_1_kg = problem.response_1_kg.diagonal().maxCoeff();
  VectorXd& impulse = memory.impulse_N_s;
  impulse = impulse_N_s;
  for (int i = 0; i < kMostSteps; ++i) {
    Projections(problem, memory).linearise();
    if (!memory.off_m_s.allFinite()) return false;
    const double most_off_m_s = memory.off_m_s.cwiseAbs().maxCoeff();
    if (most_off_m_s <= tolerance_m_s) {
      impulse_N_s = impulse;
      return true;
    }
    // Where a load may be spread in many ways, or cannot be met as it is spread, a step is no
    // longer than the impulses are.
    const double give_1_kg = most_off_m_s / impulse.cwiseAbs().maxCoeff();
    memory.slope_1_kg.diagonal().array() +=
        std::clamp(give_1_kg, 1e-12 * most_1_kg, 0.1 * most_1_kg);
    memory.factors.compute(memory.slope_1_kg);
    memory.step_N_s = memory.factors.solve(memory.off_m_s);
    impulse -= memory.step_N_s;
  }
  return false;
}

}  // namespace torquewright::simulation
