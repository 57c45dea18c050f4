// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/time_stepping.md.
#include "simulation/contact/contact_newton.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace torquewright::simulation {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// How far the impulses are from their laws, as velocities, and what a change of impulses does to
/// that; eqs. (9), (10).
struct Linearised {
  VectorXd off_m_s;
  MatrixXd slope_1_kg;
};

/// Impulse over velocity, about that of the point itself.
double scale_kg(const ContactProblem& problem, Index k) {
  return 3.0 / problem.response_1_kg.diagonal().segment<3>(3 * k).sum();
}

class Projections {
 public:
  Projections(const ContactProblem& problem, const VectorXd& impulse)
      : problem_(problem),
        impulse_(impulse),
        velocity_(problem.free_m_s + problem.response_1_kg * impulse) {}

  Linearised linearise() const {
    const Index size = impulse_.size();
    Linearised result{VectorXd(size), MatrixXd::Zero(size, size)};
    for (Index k = 0; k < size / 3; ++k) {
      const double scale = scale_kg(problem_, k);
      if (impulse_[3 * k + 2] - scale * velocity_[3 * k + 2] <= 0.0) {
        result.off_m_s.segment<3>(3 * k) = impulse_.segment<3>(3 * k) / scale;
        result.slope_1_kg.block<3, 3>(3 * k, 3 * k).diagonal().setConstant(1.0 / scale);
      } else {
        press(k, scale, result);
      }
    }
    return result;
  }

 private:
  void press(Index k, double scale, Linearised& out) const {
    const MatrixXd& W = problem_.response_1_kg;
    out.off_m_s[3 * k + 2] = velocity_[3 * k + 2];
    out.slope_1_kg.row(3 * k + 2) = W.row(3 * k + 2);
    const double mu = problem_.friction_coefficients[k];
    const double radius = mu * (impulse_[3 * k + 2] - scale * velocity_[3 * k + 2]);
    const Vector2d aim = impulse_.segment<2>(3 * k) - scale * velocity_.segment<2>(3 * k);
    const double length = aim.norm();
    if (length <= radius) {  // sticks
      out.off_m_s.segment<2>(3 * k) = velocity_.segment<2>(3 * k);
      out.slope_1_kg.middleRows<2>(3 * k) = W.middleRows<2>(3 * k);
      return;
    }
    const Vector2d along = aim / length;
    out.off_m_s.segment<2>(3 * k) = (impulse_.segment<2>(3 * k) - radius * along) / scale;
    const Matrix2d turning = radius / length * (Matrix2d::Identity() - along * along.transpose());
    auto rows = out.slope_1_kg.middleRows<2>(3 * k);
    rows = turning * W.middleRows<2>(3 * k) + mu * along * W.row(3 * k + 2);
    rows.middleCols<2>(3 * k) += (Matrix2d::Identity() - turning) / scale;
    rows.col(3 * k + 2) -= mu / scale * along;
  }

  const ContactProblem& problem_;
  const VectorXd& impulse_;
  VectorXd velocity_;
};

}  // namespace

bool newton_contacts(const ContactProblem& problem, double tolerance_m_s, VectorXd& impulse_N_s) {
  constexpr int kMostSteps = 30;
  const double most_1_kg = problem.response_1_kg.diagonal().maxCoeff();
  VectorXd impulse = impulse_N_s;
  for (int i = 0; i < kMostSteps; ++i) {
    const Linearised at = Projections(problem, impulse).linearise();
    if (!at.off_m_s.allFinite()) return false;
    if (at.off_m_s.cwiseAbs().maxCoeff() <= tolerance_m_s) {
      impulse_N_s = impulse;
      return true;
    }
    // Where a load may be spread in many ways, or cannot be met as it is spread, a step is no
    // longer than the impulses are.
    const double give_1_kg = at.off_m_s.cwiseAbs().maxCoeff() / impulse.cwiseAbs().maxCoeff();
    MatrixXd slope_1_kg = at.slope_1_kg;
    slope_1_kg.diagonal().array() += std::clamp(give_1_kg, 1e-12 * most_1_kg, 0.1 * most_1_kg);
    impulse -= slope_1_kg.partialPivLu().solve(at.off_m_s);
  }
  return false;
}

}  // namespace torquewright::simulation
