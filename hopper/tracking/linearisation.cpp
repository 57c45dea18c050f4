// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/linearisation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "dynamics/position_step.hpp"

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
    if (rows_.jacobian.rows() == 0) return w;
    return w + rows_inverse_.solve(wanted - scaled_ * w);
  }
  MatrixXd lower_inverse(const MatrixXd& force) const { return factor_.matrixL().solve(force); }
  MatrixXd upper(const MatrixXd& v) const { return factor_.matrixU() * v; }
  MatrixXd upper_inverse(const MatrixXd& w) const { return factor_.matrixU().solve(w); }
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

using ValueAt =
    std::function<std::optional<VectorXd>(const VectorXd& position, const VectorXd& velocity)>;

/// Central differences: cut-off h^2 and rounding epsilon/h are alike at the cube root of epsilon.
std::optional<MatrixXd> differences(
    Index n, const std::function<std::optional<VectorXd>(Index direction, double step)>& moved) {
  const double step = std::cbrt(std::numeric_limits<double>::epsilon());
  MatrixXd slopes(n, n);
  for (Index direction = 0; direction < n; ++direction) {
    const auto ahead = moved(direction, step);
    const auto behind = moved(direction, -step);
    if (!ahead || !behind) return std::nullopt;
    slopes.col(direction) = (*ahead - *behind) / (2.0 * step);
  }
  return slopes;
}

std::optional<MatrixXd> by_position(const dynamics::Tree& tree, const DrivenState& at,
                                    const ValueAt& value) {
  const Index n = tree.velocity_size();
  return differences(n, [&](Index direction, double step) {
    VectorXd moved(at.position.size());
    dynamics::step_position(tree, at.position, VectorXd::Unit(n, direction), step, moved);
    return value(moved, at.velocity);
  });
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

std::optional<StateSlopes> acceleration_slopes(WholeBody& body, const DrivenState& at,
                                               const TouchingPoints& touches) {
  const dynamics::Tree& tree = body.robot().tree;
  const auto value = [&](const VectorXd& position, const VectorXd& velocity) {
    return held_acceleration(body, {position, velocity, at.drive_Nm}, touches);
  };
  const auto positions = by_position(tree, at, value);
  const auto velocities = differences(tree.velocity_size(), [&](Index direction, double step) {
    return value(at.position, at.velocity + VectorXd::Unit(at.velocity.size(), direction) * step);
  });
  if (!positions || !velocities || !body.set(at.position, at.velocity)) return std::nullopt;
  const HeldBody held(body, touches);
  const MatrixXd drives = drive_jacobian(body).transpose();
  const MatrixXd nothing = MatrixXd::Zero(held.rows().jacobian.rows(), drives.cols());
  return StateSlopes{acceleration_of(body, held, at.drive_Nm), *positions, *velocities,
                     held.upper_inverse(held.held(held.lower_inverse(drives), nothing))};
}

std::optional<StateSlopes> impact_slopes(WholeBody& body, const DrivenState& at,
                                         const TouchingPoints& touches) {
  const dynamics::Tree& tree = body.robot().tree;
  const auto value = [&](const VectorXd& position,
                         const VectorXd& velocity) -> std::optional<VectorXd> {
    if (!body.set(position, velocity)) return std::nullopt;
    return after_impact(HeldBody(body, touches), velocity);
  };
  const auto positions = by_position(tree, at, value);
  if (!positions || !body.set(at.position, at.velocity)) return std::nullopt;
  const HeldBody held(body, touches);
  const Index n = tree.velocity_size();
  const MatrixXd nothing = MatrixXd::Zero(held.rows().jacobian.rows(), n);
  return StateSlopes{after_impact(held, at.velocity), *positions,
                     held.upper_inverse(held.held(held.upper(MatrixXd::Identity(n, n)), nothing)),
                     MatrixXd()};
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
