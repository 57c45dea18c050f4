// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/landing.hpp"

#include <Eigen/Geometry>

namespace torquewright::hopper {

using Eigen::Vector2d;

Landing landing_at(const dynamics::Tree& tree, double time_s, const Eigen::VectorXd& position) {
  Landing at;
  at.time_s = time_s;
  at.place_m.x() = position[0];
  if (tree.base != dynamics::BaseKind::kSpatial) return at;
  at.place_m.y() = position[1];
  const Eigen::Quaterniond turn(position[3], position[4], position[5], position[6]);
  const Eigen::Vector3d lateral = turn.normalized() * Eigen::Vector3d::UnitY();
  const Vector2d forward(lateral.y(), -lateral.x());
  if (forward.norm() > 0.0) at.forward = forward.normalized();
  return at;
}

double hopped_m(const Landing& from, const Landing& to) {
  return (to.place_m - from.place_m).dot(from.forward);
}

double hop_speed_m_s(const Landing& from, const Landing& to) {
  return hopped_m(from, to) / (to.time_s - from.time_s);
}

}  // namespace torquewright::hopper
