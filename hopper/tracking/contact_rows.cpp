// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/contact_rows.hpp"

#include <Eigen/Geometry>
#include <stdexcept>

#include "dynamics/point.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {

using Eigen::Index;

Eigen::MatrixXd ContactRows::heights() const {
  Eigen::MatrixXd rows(jacobian.rows() / 3, jacobian.cols());
  for (Index point = 0; point < rows.rows(); ++point) rows.row(point) = jacobian.row(3 * point + 2);
  return rows;
}

ContactRows contact_rows(const Robot& robot, const dynamics::TreeState& state,
                         const TouchingPoints& touches) {
  if (touches.size() != static_cast<Index>(robot.contacts.size())) {
    throw std::invalid_argument("contact rows: one flag per contact point of the robot");
  }
  const Index touching = touches.count();
  const Index n = state.tree().velocity_size();
  ContactRows rows{Eigen::MatrixXd(3 * touching, n), Eigen::VectorXd(3 * touching)};
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, n);
  for (Index contact = 0, row = 0; contact < touches.size(); ++contact) {
    if (!touches[contact]) continue;
    const ContactPoint& touching_one = robot.contacts[static_cast<std::size_t>(contact)];
    const dynamics::BodyPoint point = touching_point(touching_one, state);
    dynamics::point_jacobian(state, point, jacobian);
    rows.jacobian.middleRows<3>(row) = jacobian;
    const Eigen::Vector3d& w = state.motion(point.body).angular_velocity_rad_s;
    const Eigen::Vector3d down_m = -touching_one.radius_m * Eigen::Vector3d::UnitZ();
    rows.bias_m_s2.segment<3>(row) =
        dynamics::point_bias_acceleration_m_s2(state, point) - w.cross(w.cross(down_m));
    row += 3;
  }
  return rows;
}

}  // namespace torquewright::hopper
