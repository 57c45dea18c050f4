// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/touch_down.hpp"

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::optional<TouchDownSlopes> touch_down(WholeBody& body, const DrivenState& before,
                                          const TouchingPoints& old, const TouchingPoints& held) {
  // Slower than that the moment of touching is not one that an error of height moves.
  constexpr double kLanding_m_s = 0.05;
  const Index n = before.velocity.size();
  const TouchingPoints landing = held && !old;
  TouchDownSlopes out{MatrixXd::Identity(2 * n, 2 * n), MatrixXd::Zero(landing.count(), 2 * n)};
  if (!landing.any()) return out;
  const auto impact = impact_slopes(body, before, held);
  const auto acceleration = held_acceleration(body, before, old);
  if (!impact || !acceleration) return std::nullopt;
  VectorXd flow(2 * n);
  flow << before.velocity, *acceleration;
  const MatrixXd heights = contact_rows(body.robot(), body.state(), landing).heights();
  const Eigen::RowVectorXd height = heights.colwise().mean();
  const double approach_m_s = height.dot(before.velocity);
  MatrixXd at_contact = MatrixXd::Identity(2 * n, 2 * n);
  if (approach_m_s < -kLanding_m_s) at_contact.leftCols(n) -= flow * height / approach_m_s;
  out.after.bottomLeftCorner(n, n) = impact->by_position;
  out.after.bottomRightCorner(n, n) = impact->by_velocity;
  out.after = (out.after * at_contact).eval();
  out.unevenness = (heights.rowwise() - height) * at_contact.topRows(n);
  return out;
}

}  // namespace torquewright::hopper
