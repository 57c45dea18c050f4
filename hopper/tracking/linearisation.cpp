// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/linearisation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Below this share of the greatest a row of the contacts is another's twin.
constexpr double kTwinRow = 1e-9;

/// The ground under some points, in the coordinates w = L^T v, M = L L^T, in which energy is a sum
/// of squares: its constraints are Y^T w, and least squares are those of energy.
class HeldBody {
 public:
  HeldBody(WholeBody& body, const TouchingPoints& touches)
      : rows_(contact_rows(body.robot(), body.state(), touches)) {
    const Index n = body.state().tree().velocity_size();
    MatrixXd mass(n, n);
    body.mass_matrix(mass);
    factor_.compute(mass);
    if (rows_.jacobian.rows() == 0) return;
    scaled_ = factor_.matrixL().solve(rows_.jacobian.transpose()).transpose();
    rows_inverse_.setThreshold(kTwinRow);
    rows_inverse_.compute(scaled_);
  }

  /// Nearest in energy to w among those whose constraint rows are `wanted`.
  MatrixXd held(const MatrixXd& w, const MatrixXd& wanted) const {
    if (rows_.jacobian.rows() == 0 || w.cols() == 0) return w;
    return w + rows_inverse_.solve(wanted - scaled_ * w);
  }
  MatrixXd lower_inverse(const MatrixXd& force) const {
    if (force.cols() == 0) return force;  // nothing drives
    return factor_.matrixL().solve(force);
  }
  MatrixXd upper(const MatrixXd& v) const { return factor_.matrixU() * v; }
  MatrixXd upper_inverse(const MatrixXd& w) const {
    if (w.cols() == 0) return w;
    return factor_.matrixU().solve(w);
  }
  const ContactRows& rows() const { return rows_; }

 private:
  ContactRows rows_;
  Eigen::LLT<MatrixXd> factor_;
  MatrixXd scaled_;  ///< Y^T = J L^-T
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> rows_inverse_;
};

VectorXd acceleration_of(WholeBody& body, const HeldBody& held, const VectorXd& drive_Nm) {
  const Index n = body.state().tree().velocity_size();
  VectorXd bias(n);
  body.inverse_dynamics(VectorXd::Zero(n), bias);
  const VectorXd force = drive_jacobian(body).transpose() * drive_Nm - bias;
  return held.upper_inverse(held.held(held.lower_inverse(force), -held.rows().bias_m_s2));
}

VectorXd after_impact(const HeldBody& held, const VectorXd& velocity) {
  const MatrixXd nothing = VectorXd::Zero(held.rows().jacobian.rows());
  return held.upper_inverse(held.held(held.upper(velocity), nothing));
}

/// What holds touching points as M x = J^T force asks for: the least of those forces, by point.
Eigen::Matrix3Xd ground_N(const ContactRows& rows, const VectorXd& force,
                          const TouchingPoints& touches) {
  Eigen::Matrix3Xd out = Eigen::Matrix3Xd::Zero(3, touches.size());
  if (rows.jacobian.rows() == 0) return out;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> parts;
  parts.setThreshold(kTwinRow);
  const VectorXd held_N = parts.compute(rows.jacobian.transpose()).solve(force);
  for (Index point = 0, row = 0; point < touches.size(); ++point) {
    if (!touches[point]) continue;
    out.col(point) = held_N.segment<3>(row);
    row += 3;
  }
  return out;
}

/// Of three rows a point those of the touching ones.
MatrixXd touching_rows(const MatrixXd& all, const TouchingPoints& touches) {
  MatrixXd out(3 * touches.count(), all.cols());
  for (Index point = 0, row = 0; point < touches.size(); ++point) {
    if (!touches[point]) continue;
    out.middleRows<3>(row) = all.middleRows<3>(3 * point);
    row += 3;
  }
  return out;
}

}  // namespace

MatrixXd drive_jacobian(const WholeBody& body) {
  const Index n = body.robot().tree.velocity_size();
  MatrixXd jacobian(static_cast<Index>(body.drive_count()), n);
  for (Index i = 0; i < n; ++i) body.speed_changes(VectorXd::Unit(n, i), jacobian.col(i));
  return jacobian;
}

std::optional<VectorXd> held_acceleration(WholeBody& body, const DrivenState& at,
                                          const TouchingPoints& touches) {
  if (!body.set(at.position, at.velocity)) return std::nullopt;
  return acceleration_of(body, HeldBody(body, touches), at.drive_Nm);
}

std::optional<MatrixXd> held_answers(WholeBody& body, const DrivenState& at,
                                     const TouchingPoints& touches, const MatrixXd& forces) {
  if (!body.set(at.position, at.velocity)) return std::nullopt;
  const HeldBody held(body, touches);
  const MatrixXd nothing = MatrixXd::Zero(held.rows().jacobian.rows(), forces.cols());
  return held.upper_inverse(held.held(held.lower_inverse(forces), nothing));
}

std::optional<Eigen::Matrix3Xd> ground_forces_N(WholeBody& body, const DrivenState& at,
                                                const TouchingPoints& touches) {
  const auto acceleration = held_acceleration(body, at, touches);
  if (!acceleration) return std::nullopt;
  VectorXd force(acceleration->size());
  body.inverse_dynamics(*acceleration, force);
  force -= drive_jacobian(body).transpose() * at.drive_Nm;
  return ground_N(contact_rows(body.robot(), body.state(), touches), force, touches);
}

std::optional<StateSlopes> acceleration_slopes(WholeBody& body, LinearDynamics& dynamics,
                                               const DrivenState& at,
                                               const TouchingPoints& touches) {
  if (!body.set(at.position, at.velocity)) return std::nullopt;
  const HeldBody held(body, touches);
  const MatrixXd drives = drive_jacobian(body).transpose();
  const VectorXd acceleration = acceleration_of(body, held, at.drive_Nm);
  VectorXd force(acceleration.size());
  body.inverse_dynamics(acceleration, force);
  force -= drives * at.drive_Nm;
  DynamicsSlopes slopes;
  const bool is_reached = dynamics.at(
      {at.position, at.velocity, acceleration, at.drive_Nm, ground_N(held.rows(), force, touches)},
      slopes);
  if (!is_reached) return std::nullopt;
  // Of M a = r_0 + J^T lambda, J a = c_0 the slopes obey the same law: tracking.md eq. (4).
  const auto slope = [&](const MatrixXd& residual, const MatrixXd& contact_m_s2) {
    return held.upper_inverse(
        held.held(-held.lower_inverse(residual), -touching_rows(contact_m_s2, touches)));
  };
  const MatrixXd nothing = MatrixXd::Zero(held.rows().jacobian.rows(), drives.cols());
  return StateSlopes{acceleration,
                     slope(slopes.residual_by_position, slopes.contact_m_s2_by_position),
                     slope(slopes.residual_by_velocity, slopes.contact_m_s2_by_velocity),
                     held.upper_inverse(held.held(held.lower_inverse(drives), nothing))};
}

std::optional<StateSlopes> impact_slopes(WholeBody& body, const DrivenState& at,
                                         const TouchingPoints& touches) {
  if (!body.set(at.position, at.velocity)) return std::nullopt;
  const HeldBody held(body, touches);
  const Index n = at.velocity.size();
  const VectorXd after = after_impact(held, at.velocity), change = after - at.velocity;
  MatrixXd mass(n, n);
  body.mass_matrix(mass);
  // The residual is M a + what does not know a: its slopes at a = v+ - v- and the impulses, less
  // those at rest from both, are those of M (v+ - v-) - J^T impulses.
  LinearDynamics dynamics(body.robot());
  DynamicsSlopes struck, still;
  DynamicsInstant instant{at.position, after, change,
                          VectorXd::Zero(static_cast<Index>(body.drive_count())),
                          ground_N(held.rows(), mass * change, touches)};
  if (!dynamics.at(instant, struck)) return std::nullopt;
  instant.acceleration.setZero();
  instant.contact_N.setZero();
  if (!dynamics.at(instant, still)) return std::nullopt;
  const MatrixXd residual = struck.residual_by_position - still.residual_by_position;
  const MatrixXd nothing = MatrixXd::Zero(held.rows().jacobian.rows(), n);
  return StateSlopes{
      after,
      held.upper_inverse(held.held(-held.lower_inverse(residual),
                                   -touching_rows(struck.contact_m_s_by_position, touches))),
      held.upper_inverse(held.held(held.upper(MatrixXd::Identity(n, n)), nothing)), MatrixXd()};
}

ContinuousModel continuous_model(const dynamics::Tree& tree, const StateSlopes& acceleration,
                                 const VectorXd& velocity) {
  const Index n = tree.velocity_size();
  ContinuousModel model{MatrixXd::Zero(2 * n, 2 * n),
                        MatrixXd::Zero(2 * n, acceleration.by_drive.cols())};
  model.by_error.topRightCorner(n, n).setIdentity();
  if (tree.base == dynamics::BaseKind::kSpatial) {  // the axes of the error turn
    const Eigen::Vector3d w = velocity.segment<3>(3);
    model.by_error.block<3, 3>(3, 3) << 0, w.z(), -w.y(), -w.z(), 0, w.x(), w.y(), -w.x(), 0;
  }
  model.by_error.bottomLeftCorner(n, n) = acceleration.by_position;
  model.by_error.bottomRightCorner(n, n) = acceleration.by_velocity;
  model.by_drive.bottomRows(n) = acceleration.by_drive;
  return model;
}

DiscreteModel over(const ContinuousModel& model, double period_s) {
  const Index size = model.by_error.rows();
  const MatrixXd step = period_s * model.by_error;
  const MatrixXd identity = MatrixXd::Identity(size, size);
  // (e^X - 1)/X
  const MatrixXd mean = identity + step / 2.0 * (identity + step / 3.0 * (identity + step / 4.0));
  return {identity + step * mean, period_s * (mean * model.by_drive)};
}

}  // namespace torquewright::hopper
