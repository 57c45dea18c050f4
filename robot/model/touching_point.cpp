// SPDX-License-Identifier: Apache-2.0
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {

dynamics::BodyPoint touching_point(const ContactPoint& contact, const dynamics::TreeState& state) {
  dynamics::BodyPoint point = contact.point;
  if (contact.radius_m > 0.0) {
    const Eigen::Matrix3d& R_WB = state.motion(point.body).R_WB;
    point.p_B_m -= contact.radius_m * R_WB.transpose() * Eigen::Vector3d::UnitZ();
  }
  return point;
}

}  // namespace torquewright::hopper
