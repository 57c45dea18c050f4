// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/touch_down.hpp"

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

namespace {

/// By how much later points touch per displacement (1 x n), in s; zero where they do not come down.
RowVectorXd delays_s(const ContactRows& landing, const VectorXd& velocity) {
  // Slower than that the moment of touching is not one that an error of height moves.
  constexpr double kLanding_m_s = 0.05;
  const RowVectorXd height = landing.heights().colwise().mean();
  const double approach_m_s = height.dot(velocity);
  if (approach_m_s >= -kLanding_m_s) return RowVectorXd::Zero(velocity.size());
  return -height / approach_m_s;
}

}  // namespace

std::optional<MatrixXd> touch_down_map(WholeBody& body, const DrivenState& before,
                                       const TouchingPoints& old, const TouchingPoints& held) {
  const Index n = before.velocity.size();
  MatrixXd map = MatrixXd::Identity(2 * n, 2 * n);
  const TouchingPoints landing = held && !old;
  if (!landing.any()) return map;
  const auto impact = impact_slopes(body, before, held);
  const auto acceleration = held_acceleration(body, before, old);
  if (!impact || !acceleration) return std::nullopt;
  VectorXd flow(2 * n);
  flow << before.velocity, *acceleration;
  MatrixXd at_contact = MatrixXd::Identity(2 * n, 2 * n);
  at_contact.leftCols(n) +=
      flow * delays_s(contact_rows(body.robot(), body.state(), landing), before.velocity);
  map.bottomLeftCorner(n, n) = impact->by_position;
  map.bottomRightCorner(n, n) = impact->by_velocity;
  return map * at_contact;
}

std::optional<MatrixXd> landing_place(WholeBody& body, const DrivenState& before,
                                      const TouchingPoints& old, const TouchingPoints& held) {
  const Index n = before.velocity.size();
  MatrixXd place = MatrixXd::Zero(2, 2 * n);
  const TouchingPoints landing = held && !old;
  if (!landing.any()) return place;
  if (!body.set(before.position, before.velocity)) return std::nullopt;
  const ContactRows rows = contact_rows(body.robot(), body.state(), landing);
  const RowVectorXd delay_s = delays_s(rows, before.velocity);
  if (delay_s.isZero(0.0)) return place;
  MatrixXd middle = MatrixXd::Zero(2, n);
  for (Index row = 0; row < rows.jacobian.rows(); row += 3) {
    middle += rows.jacobian.middleRows<2>(row) / static_cast<double>(landing.count());
  }
  place.leftCols(n) = middle + middle * before.velocity * delay_s;
  return place;
}

}  // namespace torquewright::hopper
