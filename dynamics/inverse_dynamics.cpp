// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/inverse_dynamics.hpp"

#include <Eigen/Geometry>

#include "dynamics/jet.hpp"

namespace torquewright::dynamics {
namespace {

template <typename T>
using Newton = typename TreeStateOf<T>::Newton;

/// Accelerations are increased by g upwards, which is gravity's pull on everything.
template <typename T>
void accelerate_base(const TreeStateOf<T>& state, const VectorInOf<T>& a, Newton<T>& base) {
  base.angular_rad_s2.setZero();
  base.linear_m_s2 = {T(0), T(0), T(state.tree().gravity_m_s2)};
  switch (state.tree().base) {
    case BaseKind::kFixed:
      break;
    case BaseKind::kPlanar:
      base.linear_m_s2 += Vector3<T>(a[0], T(0), a[1]);
      base.angular_rad_s2.y() = a[2];
      break;
    case BaseKind::kSpatial:
      base.linear_m_s2 += a.template head<3>();
      base.angular_rad_s2 = state.motion(0).R_WB * a.template segment<3>(3);
      break;
  }
}

// eqs. (4), (5)
template <typename T>
void accelerate(const TreeStateOf<T>& state, std::size_t index, const T& acceleration,
                const Newton<T>& parent, Newton<T>& body) {
  const BodyMotionOf<T>& motion = state.motion(index);
  const Body& of = state.tree().bodies[index];
  const Vector3<T>& w = state.motion(of.parent).angular_velocity_rad_s;
  const Vector3<T>& d = motion.from_parent_m;
  const Vector3<T> turned = state.joint_velocity(index) * w.cross(motion.axis);
  body.angular_rad_s2 = parent.angular_rad_s2;
  body.linear_m_s2 = parent.linear_m_s2 + parent.angular_rad_s2.cross(d) + w.cross(w.cross(d));
  if (of.joint.kind == JointKind::kRevolute) {
    body.angular_rad_s2 += acceleration * motion.axis + turned;
  } else {
    body.linear_m_s2 += acceleration * motion.axis + 2.0 * turned;
  }
}

/// What the body's own mass needs; eq. (6).
template <typename T>
void load(const RigidInertia& inertia, const BodyMotionOf<T>& motion, Newton<T>& body) {
  const Vector3<T>& w = motion.angular_velocity_rad_s;
  const Vector3<T> arm_m = motion.center_of_mass_m - motion.origin_m;
  body.force_N = inertia.mass_kg *
                 (body.linear_m_s2 + body.angular_rad_s2.cross(arm_m) + w.cross(w.cross(arm_m)));
  const Vector3<T> w_B = motion.R_WB.transpose() * w;
  const Vector3<T> moment_B_Nm =
      inertia.inertia_kg_m2 * (motion.R_WB.transpose() * body.angular_rad_s2) +
      w_B.cross(inertia.inertia_kg_m2 * w_B);
  body.moment_Nm = motion.R_WB * moment_B_Nm + arm_m.cross(body.force_N);
}

/// Force along the joint, and what remains for the parent; eqs. (7), (8).
template <typename T>
T hand_on(const TreeStateOf<T>& state, std::size_t index, const T& acceleration,
          const Newton<T>& body, Newton<T>& parent) {
  const Body& of = state.tree().bodies[index];
  const BodyMotionOf<T>& motion = state.motion(index);
  parent.force_N += body.force_N;
  parent.moment_Nm += body.moment_Nm + motion.from_parent_m.cross(body.force_N);
  const T along = of.joint.kind == JointKind::kRevolute ? motion.axis.dot(body.moment_Nm)
                                                        : motion.axis.dot(body.force_N);
  T force = along + of.joint.reflected_inertia * acceleration;
  if (!of.joint.rotor_spin_kg_m2.isZero(0)) {
    const BodyMotionOf<T>& carrier = state.motion(of.parent);
    const Vector3<T> spin = carrier.R_WB * of.joint.rotor_spin_kg_m2;
    parent.moment_Nm += spin * acceleration +
                        carrier.angular_velocity_rad_s.cross(spin) * state.joint_velocity(index);
    force += spin.dot(parent.angular_rad_s2);
  }
  return force;
}

template <typename T>
void hold_base(const TreeStateOf<T>& state, const Newton<T>& base, VectorOutOf<T>& force) {
  switch (state.tree().base) {
    case BaseKind::kFixed:
      break;
    case BaseKind::kPlanar:
      force.template head<3>() << base.force_N.x(), base.force_N.z(), base.moment_Nm.y();
      break;
    case BaseKind::kSpatial:
      force.template head<3>() = base.force_N;
      force.template segment<3>(3) = state.motion(0).R_WB.transpose() * base.moment_Nm;
      break;
  }
}

}  // namespace

template <typename T>
void inverse_dynamics(TreeStateOf<T>& state, const VectorInOf<T>& acceleration,
                      VectorOutOf<T> force) {
  require_velocity_size(state, acceleration.size());
  require_velocity_size(state, force.size());
  const std::vector<Body>& bodies = state.tree().bodies;
  std::vector<Newton<T>>& newton = state.newton();
  accelerate_base<T>(state, acceleration, newton.front());
  load<T>(bodies.front().inertia, state.motion(0), newton.front());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    accelerate<T>(state, i, acceleration[state.joint_row(i)], newton[bodies[i].parent], newton[i]);
    load<T>(bodies[i].inertia, state.motion(i), newton[i]);
  }
  for (std::size_t i = bodies.size() - 1; i > 0; --i) {
    const Eigen::Index row = state.joint_row(i);
    force[row] = hand_on<T>(state, i, acceleration[row], newton[i], newton[bodies[i].parent]);
  }
  hold_base<T>(state, newton.front(), force);
}

template <typename T>
void bias(TreeStateOf<T>& state, VectorOutOf<T> force) {
  state.vector_scratch().setZero();
  inverse_dynamics(state, state.vector_scratch(), force);
}

template void inverse_dynamics(TreeState&, const VectorInOf<double>&, VectorOutOf<double>);
template void bias(TreeState&, VectorOutOf<double>);
template void inverse_dynamics(TreeStateOf<Jet>&, const VectorInOf<Jet>&, VectorOutOf<Jet>);
template void bias(TreeStateOf<Jet>&, VectorOutOf<Jet>);
template void inverse_dynamics(TreeStateOf<Jet2>&, const VectorInOf<Jet2>&, VectorOutOf<Jet2>);
template void bias(TreeStateOf<Jet2>&, VectorOutOf<Jet2>);

}  // namespace torquewright::dynamics
