// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/point.hpp"

#include <Eigen/Geometry>
#include <stdexcept>

#include "dynamics/columns.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::Vector3d;

/// From the base's origin, as all of BodyMotion.
Vector3d from_base_m(const TreeState& state, const BodyPoint& point) {
  const BodyMotion& motion = state.motion(point.body);
  return motion.origin_m + motion.R_WB * point.p_B_m;
}

void require_jacobian(const TreeState& state, Eigen::Index columns) {
  if (columns != state.velocity().size()) {
    throw std::invalid_argument("jacobian: one column per velocity");
  }
}

/// Calls use(column index, column) for every velocity that moves the body.
template <typename Use>
void for_each_column(const TreeState& state, std::size_t body, const Use& use) {
  for (; body > 0; body = state.tree().bodies[body].parent) {
    use(state.joint_row(body), joint_column(state, body));
  }
  for (Eigen::Index k = 0; k < state.tree().base_velocity_size(); ++k) {
    use(k, base_column(state, k));
  }
}

struct Acceleration {
  Vector3d angular_rad_s2;
  Vector3d linear_m_s2;  // of the body's origin
};

// eqs. (4), (5) with q'' = 0 and without gravity
Acceleration bias_acceleration(const TreeState& state, std::size_t body) {
  if (body == 0) return {Vector3d::Zero(), Vector3d::Zero()};
  const Body& of = state.tree().bodies[body];
  Acceleration result = bias_acceleration(state, of.parent);
  const BodyMotion& motion = state.motion(body);
  const Vector3d& w = state.motion(of.parent).angular_velocity_rad_s;
  const Vector3d& d = motion.from_parent_m;
  const Vector3d turned = state.joint_velocity(body) * w.cross(motion.axis);
  result.linear_m_s2 += result.angular_rad_s2.cross(d) + w.cross(w.cross(d));
  if (of.joint.kind == JointKind::kRevolute) {
    result.angular_rad_s2 += turned;
  } else {
    result.linear_m_s2 += 2 * turned;
  }
  return result;
}

}  // namespace

Vector3d point_position_m(const TreeState& state, const BodyPoint& point) {
  return state.base_origin_m() + from_base_m(state, point);
}

Vector3d point_velocity_m_s(const TreeState& state, const BodyPoint& point) {
  const BodyMotion& motion = state.motion(point.body);
  return motion.velocity_m_s + motion.angular_velocity_rad_s.cross(motion.R_WB * point.p_B_m);
}

void point_jacobian(const TreeState& state, const BodyPoint& point, Jacobian out) {
  require_jacobian(state, out.cols());
  out.setZero();
  const Vector3d at_m = from_base_m(state, point);
  for_each_column(state, point.body, [&](Eigen::Index k, const Column& column) {
    out.col(k) = column.linear + column.angular.cross(at_m);
  });
}

void rotation_jacobian(const TreeState& state, std::size_t body, Jacobian out) {
  require_jacobian(state, out.cols());
  out.setZero();
  for_each_column(state, body,
                  [&](Eigen::Index k, const Column& column) { out.col(k) = column.angular; });
}

Vector3d point_bias_acceleration_m_s2(const TreeState& state, const BodyPoint& point) {
  const Acceleration body = bias_acceleration(state, point.body);
  const Vector3d& w = state.motion(point.body).angular_velocity_rad_s;
  const Vector3d arm_m = state.motion(point.body).R_WB * point.p_B_m;
  return body.linear_m_s2 + body.angular_rad_s2.cross(arm_m) + w.cross(w.cross(arm_m));
}

void add_point_force(const TreeState& state, const BodyPoint& point, const Vector3d& force_N,
                     VectorOut force) {
  require_velocity_size(state, force.size());
  const Vector3d moment_Nm = from_base_m(state, point).cross(force_N);
  for_each_column(state, point.body, [&](Eigen::Index k, const Column& column) {
    force[k] += column.linear.dot(force_N) + column.angular.dot(moment_Nm);
  });
}

}  // namespace torquewright::dynamics
