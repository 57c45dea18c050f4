// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/error_space.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "dynamics/position_step.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Directions in which rows do not change; orthonormal.
MatrixXd kernel(const MatrixXd& rows) {
  constexpr double kTwinRow = 1e-9;
  const Index n = rows.cols();
  if (rows.rows() == 0) return MatrixXd::Identity(n, n);
  Eigen::JacobiSVD<MatrixXd> svd(rows, Eigen::ComputeFullV);
  svd.setThreshold(kTwinRow);
  return svd.matrixV().rightCols(n - svd.rank());
}

/// How the base's velocity along the world turns with the heading, per unfelt direction (n x k).
MatrixXd turned_velocities(const dynamics::TreeState& state, Index directions) {
  MatrixXd turned = MatrixXd::Zero(state.tree().velocity_size(), directions);
  if (state.tree().base != dynamics::BaseKind::kSpatial) return turned;
  turned.col(2).head<3>() = Eigen::Vector3d::UnitZ().cross(state.velocity().head<3>());
  return turned;
}

/// How the touching points' velocities change along some directions of the positions.
std::optional<MatrixXd> velocity_slopes(WholeBody& body, const VectorXd& position,
                                        const VectorXd& velocity, const TouchingPoints& touches,
                                        const MatrixXd& directions) {
  const double step = std::cbrt(std::numeric_limits<double>::epsilon());
  MatrixXd slopes(3 * touches.count(), directions.cols());
  for (Index i = 0; i < directions.cols(); ++i) {
    VectorXd moved(position.size());
    VectorXd apart = VectorXd::Zero(slopes.rows());
    for (const double side : {1.0, -1.0}) {
      dynamics::step_position(body.robot().tree, position, directions.col(i), side * step, moved);
      if (!body.set(moved, velocity)) return std::nullopt;
      apart += side * (contact_rows(body.robot(), body.state(), touches).jacobian * velocity);
    }
    slopes.col(i) = apart / (2.0 * step);
  }
  return slopes;
}

/// (N^T M N)^-1 N^T M: of any vector the part in N that is nearest in energy.
MatrixXd nearest_part(const MatrixXd& basis, const MatrixXd& mass) {
  const MatrixXd weighted = basis.transpose() * mass;
  return (weighted * basis).llt().solve(weighted);
}

}  // namespace

MatrixXd unfelt_directions(const dynamics::TreeState& state) {
  const Index n = state.tree().velocity_size();
  if (state.tree().base == dynamics::BaseKind::kFixed) return MatrixXd(n, 0);
  if (state.tree().base == dynamics::BaseKind::kPlanar) return MatrixXd::Identity(n, 1);
  MatrixXd directions = MatrixXd::Zero(n, 3);
  directions.topLeftCorner<2, 2>().setIdentity();
  directions.block<3, 1>(3, 2) = state.motion(0).R_WB.transpose() * Eigen::Vector3d::UnitZ();
  return directions;
}

std::optional<ErrorSpace> error_space(WholeBody& body, const VectorXd& position,
                                      const VectorXd& velocity, const TouchingPoints& touches) {
  if (!body.set(position, velocity)) return std::nullopt;
  const Index n = velocity.size();
  const MatrixXd unfelt = unfelt_directions(body.state());
  const MatrixXd turned = turned_velocities(body.state(), unfelt.cols());
  const ContactRows rows = contact_rows(body.robot(), body.state(), touches);
  MatrixXd mass(n, n);
  body.mass_matrix(mass);

  MatrixXd level(unfelt.cols() + touches.count(), n);
  level << unfelt.transpose(), rows.heights();
  const MatrixXd free_positions = kernel(level);
  const MatrixXd free_velocities = kernel(rows.jacobian);
  MatrixXd carried = MatrixXd::Zero(n, free_positions.cols());
  if (touches.any()) {
    const auto slopes = velocity_slopes(body, position, velocity, touches, free_positions);
    if (!slopes) return std::nullopt;
    const MatrixXd answer = mass.llt().solve(rows.jacobian.transpose());
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> mobility;
    mobility.setThreshold(1e-9);
    mobility.compute(rows.jacobian * answer);
    carried = -answer * mobility.solve(*slopes);
  }

  const Index places = free_positions.cols(), speeds = free_velocities.cols();
  ErrorSpace space{MatrixXd::Zero(2 * n, places + speeds), MatrixXd::Zero(places + speeds, 2 * n)};
  space.from_free.topLeftCorner(n, places) = free_positions;
  space.from_free.bottomLeftCorner(n, places) = carried;
  space.from_free.bottomRightCorner(n, speeds) = free_velocities;
  space.to_free.topLeftCorner(places, n) = nearest_part(free_positions, mass);
  space.to_free.bottomRightCorner(speeds, n) = nearest_part(free_velocities, mass);
  MatrixXd aligned = MatrixXd::Identity(2 * n, 2 * n);
  aligned.topLeftCorner(n, n) -= unfelt * unfelt.transpose();
  aligned.bottomLeftCorner(n, n) -= turned * unfelt.transpose();
  space.to_free = (space.to_free * aligned).eval();
  return space;
}

AlignedError aligned_error(const dynamics::Tree& tree, const ReferenceInstant& wanted,
                           const VectorXd& position, const VectorXd& velocity) {
  const Index n = velocity.size();
  AlignedError out{position, velocity, VectorXd(2 * n)};
  if (tree.base == dynamics::BaseKind::kPlanar) out.position[0] = wanted.position[0];
  if (tree.base == dynamics::BaseKind::kSpatial) {
    const auto turn_of = [](const VectorXd& at) {
      return Eigen::Quaterniond(at[3], at[4], at[5], at[6]).normalized();
    };
    const Eigen::Quaterniond there = turn_of(wanted.position), here = turn_of(position);
    // The turn about the vertical that leaves the least between the two: of q = here there^-1 the
    // part along z.
    const Eigen::Quaterniond between = here * there.conjugate();
    const double size = std::hypot(between.w(), between.z());
    Eigen::Quaterniond heading = Eigen::Quaterniond::Identity();
    if (size > 0.0) heading = {between.w() / size, 0.0, 0.0, between.z() / size};
    const Eigen::Quaterniond turned = heading.conjugate() * here;
    out.position.segment<2>(0) = wanted.position.segment<2>(0);
    out.position.segment<4>(3) << turned.w(), turned.x(), turned.y(), turned.z();
    out.velocity.head<3>() = heading.conjugate() * velocity.head<3>();
  }
  dynamics::position_difference(tree, wanted.position, out.position, out.error.head(n));
  out.error.tail(n) = out.velocity - wanted.velocity;
  return out;
}

}  // namespace torquewright::hopper
