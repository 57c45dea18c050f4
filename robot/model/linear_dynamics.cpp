// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/jets.md.
#include "robot/model/linear_dynamics.hpp"

#include <Eigen/Geometry>
#include <stdexcept>

#include "dynamics/point.hpp"
#include "dynamics/seeds.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::Jet;
using dynamics::Vector3;
using dynamics::VectorX;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using JetState = dynamics::TreeStateOf<Jet>;

/// Values of which those numbered first .. first + kMostVariables - 1 are variables; `number` is
/// that of the first value.
VectorX<Jet> partly_seeded(const VectorXd& values, int number, int first) {
  VectorX<Jet> out = values.cast<Jet>();
  for (Index i = 0; i < values.size(); ++i) {
    const int variable = number + static_cast<int>(i) - first;
    if (variable < 0 || variable >= dynamics::kMostVariables) continue;
    out[i] = Jet::variable(values[i], variable);
  }
  return out;
}

/// From a contact's point to what touches there, in the world's axes: under the centre of a ball.
Vector3d to_ground_m(const ContactPoint& contact) { return {0, 0, -contact.radius_m}; }

Vector3<Jet> touching_speed_m_s(const JetState& state, const ContactPoint& contact) {
  return dynamics::point_velocity_m_s(state, contact.point) +
         state.motion(contact.point.body).angular_velocity_rad_s.cross(to_ground_m(contact));
}

/// Its rate. Requires that inverse dynamics have just left the bodies' accelerations.
Vector3<Jet> touching_rate_m_s2(JetState& state, const ContactPoint& contact) {
  const JetState::Newton& body = state.newton()[contact.point.body];
  const auto& motion = state.motion(contact.point.body);
  const Vector3<Jet>& w = motion.angular_velocity_rad_s;
  const Vector3<Jet> arm_m = motion.R_WB * contact.point.p_B_m;
  const Vector3<Jet> bent = w.cross(w.cross(arm_m));
  const Vector3<Jet> reach_m = arm_m + to_ground_m(contact);
  Vector3<Jet> rate = body.linear_m_s2 + body.angular_rad_s2.cross(reach_m) + bent;
  rate.z() -= state.tree().gravity_m_s2;  // which inverse dynamics adds to all
  return rate;
}

/// Writes derivatives into the columns of displacements or velocities that this pass holds.
void scatter(const VectorX<Jet>& values, Index row, int number, int first, MatrixXd& out) {
  for (Index i = 0; i < values.size(); ++i) {
    for (Index j = 0; j < out.cols(); ++j) {
      const int variable = number + static_cast<int>(j) - first;
      if (variable < 0 || variable >= dynamics::kMostVariables) continue;
      out(row + i, j) = values[i].slope(variable);
    }
  }
}

void write_values(const VectorX<Jet>& values, Index row, VectorXd& out) {
  for (Index i = 0; i < values.size(); ++i) out[row + i] = values[i].value();
}

void require_sizes(const DynamicsInstant& instant, const Robot& robot, std::size_t drives) {
  const Index n = robot.tree.velocity_size();
  if (instant.position.size() != robot.tree.position_size() || instant.velocity.size() != n ||
      instant.acceleration.size() != n || instant.drive_Nm.size() != static_cast<Index>(drives) ||
      instant.contact_N.cols() != static_cast<Index>(robot.contacts.size())) {
    throw std::invalid_argument("linear dynamics: vectors of other sizes than the robot's");
  }
  if (!instant.acceleration.allFinite() || !instant.drive_Nm.allFinite() ||
      !instant.contact_N.allFinite()) {
    throw std::invalid_argument("linear dynamics: a number is not finite");
  }
}

void resize(Index n, Index points, DynamicsSlopes& out) {
  out.residual.resize(n);
  out.contact_m_s.resize(3 * points);
  out.contact_m_s2.resize(3 * points);
  for (MatrixXd* matrix : {&out.residual_by_position, &out.residual_by_velocity}) {
    matrix->resize(n, n);
  }
  for (MatrixXd* matrix : {&out.contact_m_s_by_position, &out.contact_m_s2_by_position,
                           &out.contact_m_s2_by_velocity}) {
    matrix->resize(3 * points, n);
  }
}

}  // namespace

bool LinearDynamics::at(const DynamicsInstant& instant, DynamicsSlopes& out) {
  const Robot& robot = body_.robot();
  require_sizes(instant, robot, body_.drive_count());
  const auto n = static_cast<int>(robot.tree.velocity_size());
  resize(n, static_cast<Index>(robot.contacts.size()), out);
  for (int first = 0; first < 2 * n; first += dynamics::kMostVariables) {
    if (!pass(instant, first, out)) return false;
  }
  return true;
}

bool LinearDynamics::pass(const DynamicsInstant& instant, int first, DynamicsSlopes& out) {
  const dynamics::Tree& tree = body_.robot().tree;
  const Index n = tree.velocity_size();
  const auto rates = static_cast<int>(n);  // velocities are numbered after displacements
  const VectorX<Jet> by = partly_seeded(VectorXd::Zero(n), 0, first);
  const VectorX<Jet> velocity = partly_seeded(instant.velocity, rates, first);
  if (!body_.set(dynamics::displaced<Jet>(tree, instant.position, by), velocity)) return false;
  VectorX<Jet> residual(n), others = contact_force(instant);
  body_.inverse_dynamics(instant.acceleration.cast<Jet>(), residual);
  body_.add_drive_torques(instant.drive_Nm.cast<Jet>(), others);
  residual -= others;
  write_values(residual, 0, out.residual);
  scatter(residual, 0, 0, first, out.residual_by_position);
  scatter(residual, 0, rates, first, out.residual_by_velocity);
  contact_rows(first, out);
  return true;
}

void LinearDynamics::contact_rows(int first, DynamicsSlopes& out) {
  const auto rates = static_cast<int>(body_.robot().tree.velocity_size());
  Index row = 0;
  for (const ContactPoint& contact : body_.robot().contacts) {
    const VectorX<Jet> speed = touching_speed_m_s(body_.state(), contact);
    const VectorX<Jet> rate = touching_rate_m_s2(body_.state(), contact);
    write_values(speed, row, out.contact_m_s);
    write_values(rate, row, out.contact_m_s2);
    scatter(speed, row, 0, first, out.contact_m_s_by_position);
    scatter(rate, row, 0, first, out.contact_m_s2_by_position);
    scatter(rate, row, rates, first, out.contact_m_s2_by_velocity);
    row += 3;
  }
}

VectorX<Jet> LinearDynamics::contact_force(const DynamicsInstant& instant) {
  const JetState& state = body_.state();
  const Index n = instant.velocity.size();
  VectorX<Jet> force = VectorX<Jet>::Zero(n);
  for (std::size_t i = 0; i < body_.robot().contacts.size(); ++i) {
    const ContactPoint& contact = body_.robot().contacts[i];
    const Vector3d force_N = instant.contact_N.col(static_cast<Index>(i));
    if (force_N.isZero(0)) continue;
    dynamics::add_point_force(state, contact.point, force_N.cast<Jet>(), force);
    if (!(contact.radius_m > 0)) continue;
    Eigen::Matrix<Jet, 3, Eigen::Dynamic> turns(3, n);
    dynamics::rotation_jacobian(state, contact.point.body, turns);
    force += turns.transpose() * to_ground_m(contact).cross(force_N);
  }
  return force;
}

}  // namespace torquewright::hopper
