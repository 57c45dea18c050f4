// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/point.hpp"

#include <Eigen/Geometry>
#include <stdexcept>

#include "dynamics/columns.hpp"
#include "dynamics/jet.hpp"

namespace torquewright::dynamics {
namespace {

/// From the base's origin, as all of BodyMotion.
template <typename T>
Vector3<T> from_base_m(const TreeStateOf<T>& state, const BodyPoint& point) {
  const BodyMotionOf<T>& motion = state.motion(point.body);
  return motion.origin_m + motion.R_WB * point.p_B_m;
}

template <typename T>
void require_jacobian(const TreeStateOf<T>& state, Eigen::Index columns) {
  if (columns != state.velocity().size()) {
    throw std::invalid_argument("jacobian: one column per velocity");
  }
}

/// Calls use(column index, column) for every velocity that moves the body.
template <typename T, typename Use>
void for_each_column(const TreeStateOf<T>& state, std::size_t body, const Use& use) {
  for (; body > 0; body = state.tree().bodies[body].parent) {
    use(state.joint_row(body), joint_column(state, body));
  }
  for (Eigen::Index k = 0; k < state.tree().base_velocity_size(); ++k) {
    use(k, base_column(state, k));
  }
}

template <typename T>
struct Acceleration {
  Vector3<T> angular_rad_s2;
  Vector3<T> linear_m_s2;  // of the body's origin
};

// eqs. (4), (5) with q'' = 0 and without gravity
template <typename T>
Acceleration<T> bias_acceleration(const TreeStateOf<T>& state, std::size_t body) {
  if (body == 0) return {Vector3<T>::Zero(), Vector3<T>::Zero()};
  const Body& of = state.tree().bodies[body];
  Acceleration<T> result = bias_acceleration(state, of.parent);
  const BodyMotionOf<T>& motion = state.motion(body);
  const Vector3<T>& w = state.motion(of.parent).angular_velocity_rad_s;
  const Vector3<T>& d = motion.from_parent_m;
  const Vector3<T> turned = state.joint_velocity(body) * w.cross(motion.axis);
  result.linear_m_s2 += result.angular_rad_s2.cross(d) + w.cross(w.cross(d));
  if (of.joint.kind == JointKind::kRevolute) {
    result.angular_rad_s2 += turned;
  } else {
    result.linear_m_s2 += 2.0 * turned;
  }
  return result;
}

}  // namespace

template <typename T>
Vector3<T> point_position_m(const TreeStateOf<T>& state, const BodyPoint& point) {
  return state.base_origin_m() + from_base_m(state, point);
}

template <typename T>
Vector3<T> point_velocity_m_s(const TreeStateOf<T>& state, const BodyPoint& point) {
  const BodyMotionOf<T>& motion = state.motion(point.body);
  return motion.velocity_m_s + motion.angular_velocity_rad_s.cross(motion.R_WB * point.p_B_m);
}

template <typename T>
void point_jacobian(const TreeStateOf<T>& state, const BodyPoint& point, JacobianOf<T> out) {
  require_jacobian(state, out.cols());
  out.setZero();
  const Vector3<T> at_m = from_base_m(state, point);
  for_each_column(state, point.body, [&](Eigen::Index k, const ColumnOf<T>& column) {
    out.col(k) = column.linear + column.angular.cross(at_m);
  });
}

template <typename T>
void rotation_jacobian(const TreeStateOf<T>& state, std::size_t body, JacobianOf<T> out) {
  require_jacobian(state, out.cols());
  out.setZero();
  for_each_column(state, body,
                  [&](Eigen::Index k, const ColumnOf<T>& column) { out.col(k) = column.angular; });
}

template <typename T>
Vector3<T> point_bias_acceleration_m_s2(const TreeStateOf<T>& state, const BodyPoint& point) {
  const Acceleration<T> body = bias_acceleration(state, point.body);
  const Vector3<T>& w = state.motion(point.body).angular_velocity_rad_s;
  const Vector3<T> arm_m = state.motion(point.body).R_WB * point.p_B_m;
  return body.linear_m_s2 + body.angular_rad_s2.cross(arm_m) + w.cross(w.cross(arm_m));
}

template <typename T>
void add_point_force(const TreeStateOf<T>& state, const BodyPoint& point,
                     const Vector3In<T>& force_N, VectorOutOf<T> force) {
  require_velocity_size(state, force.size());
  const Vector3<T> moment_Nm = from_base_m(state, point).cross(force_N);
  for_each_column(state, point.body, [&](Eigen::Index k, const ColumnOf<T>& column) {
    force[k] += column.linear.dot(force_N) + column.angular.dot(moment_Nm);
  });
}

template Vector3<double> point_position_m(const TreeState&, const BodyPoint&);
template Vector3<double> point_velocity_m_s(const TreeState&, const BodyPoint&);
template void point_jacobian(const TreeState&, const BodyPoint&, JacobianOf<double>);
template void rotation_jacobian(const TreeState&, std::size_t, JacobianOf<double>);
template Vector3<double> point_bias_acceleration_m_s2(const TreeState&, const BodyPoint&);
template void add_point_force(const TreeState&, const BodyPoint&, const Vector3<double>&,
                              VectorOutOf<double>);
template Vector3<Jet> point_position_m(const TreeStateOf<Jet>&, const BodyPoint&);
template Vector3<Jet> point_velocity_m_s(const TreeStateOf<Jet>&, const BodyPoint&);
template void point_jacobian(const TreeStateOf<Jet>&, const BodyPoint&, JacobianOf<Jet>);
template void rotation_jacobian(const TreeStateOf<Jet>&, std::size_t, JacobianOf<Jet>);
template Vector3<Jet> point_bias_acceleration_m_s2(const TreeStateOf<Jet>&, const BodyPoint&);
template void add_point_force(const TreeStateOf<Jet>&, const BodyPoint&, const Vector3<Jet>&,
                              VectorOutOf<Jet>);
template Vector3<Jet2> point_position_m(const TreeStateOf<Jet2>&, const BodyPoint&);
template Vector3<Jet2> point_velocity_m_s(const TreeStateOf<Jet2>&, const BodyPoint&);
template void point_jacobian(const TreeStateOf<Jet2>&, const BodyPoint&, JacobianOf<Jet2>);
template void rotation_jacobian(const TreeStateOf<Jet2>&, std::size_t, JacobianOf<Jet2>);
template Vector3<Jet2> point_bias_acceleration_m_s2(const TreeStateOf<Jet2>&, const BodyPoint&);
template void add_point_force(const TreeStateOf<Jet2>&, const BodyPoint&, const Vector3<Jet2>&,
                              VectorOutOf<Jet2>);

}  // namespace torquewright::dynamics
