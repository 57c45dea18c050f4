// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/inverse_dynamics.hpp"

#include <Eigen/Geometry>

namespace torquewright::dynamics {
namespace {

using Eigen::Vector3d;
using Newton = TreeState::Newton;

/// Accelerations are increased by g upwards, which is gravity's pull on everything.
void accelerate_base(const TreeState& state, const VectorIn& a, Newton& base) {
  base.angular_rad_s2.setZero();
  base.linear_m_s2 = {0, 0, state.tree().gravity_m_s2};
  switch (state.tree().base) {
    case BaseKind::kFixed:
      break;
    case BaseKind::kPlanar:
      base.linear_m_s2 += Vector3d(a[0], 0, a[1]);
      base.angular_rad_s2.y() = a[2];
      break;
    case BaseKind::kSpatial:
      base.linear_m_s2 += a.head<3>();
      base.angular_rad_s2 = state.motion(0).R_WB * a.segment<3>(3);
      break;
  }
}

// eqs. (4), (5)
void accelerate(const TreeState& state, std::size_t index, double acceleration,
                const Newton& parent, Newton& body) {
  const BodyMotion& motion = state.motion(index);
  const Body& of = state.tree().bodies[index];
  const Vector3d& w = state.motion(of.parent).angular_velocity_rad_s;
  const Vector3d& d = motion.from_parent_m;
  const Vector3d turned = state.joint_velocity(index) * w.cross(motion.axis);
  body.angular_rad_s2 = parent.angular_rad_s2;
  body.linear_m_s2 = parent.linear_m_s2 + parent.angular_rad_s2.cross(d) + w.cross(w.cross(d));
  if (of.joint.kind == JointKind::kRevolute) {
    body.angular_rad_s2 += acceleration * motion.axis + turned;
  } else {
    body.linear_m_s2 += acceleration * motion.axis + 2 * turned;
  }
}

/// What the body's own mass needs; eq. (6).
void load(const RigidInertia& inertia, const BodyMotion& motion, Newton& body) {
  const Vector3d& w = motion.angular_velocity_rad_s;
  const Vector3d arm_m = motion.center_of_mass_m - motion.origin_m;
  body.force_N = inertia.mass_kg *
                 (body.linear_m_s2 + body.angular_rad_s2.cross(arm_m) + w.cross(w.cross(arm_m)));
  const Vector3d w_B = motion.R_WB.transpose() * w;
  const Vector3d moment_B_Nm =
      inertia.inertia_kg_m2 * (motion.R_WB.transpose() * body.angular_rad_s2) +
      w_B.cross(inertia.inertia_kg_m2 * w_B);
  body.moment_Nm = motion.R_WB * moment_B_Nm + arm_m.cross(body.force_N);
}

/// Force along the joint, and what remains for the parent; eqs. (7), (8).
double hand_on(const TreeState& state, std::size_t index, double acceleration, const Newton& body,
               Newton& parent) {
  const Body& of = state.tree().bodies[index];
  const BodyMotion& motion = state.motion(index);
  parent.force_N += body.force_N;
  parent.moment_Nm += body.moment_Nm + motion.from_parent_m.cross(body.force_N);
  const double along = of.joint.kind == JointKind::kRevolute ? motion.axis.dot(body.moment_Nm)
                                                             : motion.axis.dot(body.force_N);
  double force = along + of.joint.reflected_inertia * acceleration;
  if (!of.joint.rotor_spin_kg_m2.isZero(0)) {
    const BodyMotion& carrier = state.motion(of.parent);
    const Vector3d spin = carrier.R_WB * of.joint.rotor_spin_kg_m2;
    parent.moment_Nm += spin * acceleration +
                        carrier.angular_velocity_rad_s.cross(spin) * state.joint_velocity(index);
    force += spin.dot(parent.angular_rad_s2);
  }
  return force;
}

void hold_base(const TreeState& state, const Newton& base, VectorOut& force) {
  switch (state.tree().base) {
    case BaseKind::kFixed:
      break;
    case BaseKind::kPlanar:
      force.head<3>() << base.force_N.x(), base.force_N.z(), base.moment_Nm.y();
      break;
    case BaseKind::kSpatial:
      force.head<3>() = base.force_N;
      force.segment<3>(3) = state.motion(0).R_WB.transpose() * base.moment_Nm;
      break;
  }
}

}  // namespace

void inverse_dynamics(TreeState& state, const VectorIn& acceleration, VectorOut force) {
  require_velocity_size(state, acceleration.size());
  require_velocity_size(state, force.size());
  const std::vector<Body>& bodies = state.tree().bodies;
  std::vector<Newton>& newton = state.newton();
  accelerate_base(state, acceleration, newton.front());
  load(bodies.front().inertia, state.motion(0), newton.front());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    accelerate(state, i, acceleration[state.joint_row(i)], newton[bodies[i].parent], newton[i]);
    load(bodies[i].inertia, state.motion(i), newton[i]);
  }
  for (std::size_t i = bodies.size() - 1; i > 0; --i) {
    const Eigen::Index row = state.joint_row(i);
    force[row] = hand_on(state, i, acceleration[row], newton[i], newton[bodies[i].parent]);
  }
  hold_base(state, newton.front(), force);
}

void bias(TreeState& state, VectorOut force) {
  state.vector_scratch().setZero();
  inverse_dynamics(state, state.vector_scratch(), force);
}

}  // namespace torquewright::dynamics
