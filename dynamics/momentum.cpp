// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/momentum.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "dynamics/composite.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Inertias below this share of the largest are those of needles and points: no turn about them.
constexpr double kNoInertia = 1e-14;

Vector3d center_velocity_m_s(const TreeState& state, std::size_t body) {
  const BodyMotion& motion = state.motion(body);
  return motion.velocity_m_s +
         motion.angular_velocity_rad_s.cross(motion.center_of_mass_m - motion.origin_m);
}

Vector3d spin_momentum_Nm_s(const TreeState& state, std::size_t body) {
  const Body& of = state.tree().bodies[body];
  return state.motion(of.parent).R_WB * of.joint.rotor_spin_kg_m2 * state.joint_velocity(body);
}

/// I^-1 L; eq. (15).
Vector3d average_velocity(const Matrix3d& inertia, const Vector3d& momentum) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> axes;
  axes.compute(inertia);
  const double least = kNoInertia * axes.eigenvalues().cwiseAbs().maxCoeff();
  Vector3d components = axes.eigenvectors().transpose() * momentum;
  for (Eigen::Index k = 0; k < 3; ++k) {
    components[k] = axes.eigenvalues()[k] > least ? components[k] / axes.eigenvalues()[k] : 0;
  }
  return axes.eigenvectors() * components;
}

void set_column(MatrixOut& out, Eigen::Index column, const Momentum& momentum,
                const Vector3d& center_m) {
  out.col(column).head<3>() = momentum.angular_Nm_s - center_m.cross(momentum.linear_N_s);
  out.col(column).tail<3>() = momentum.linear_N_s;
}

}  // namespace

Centroid centroid(TreeState& state) {
  gather_composites(state);
  const TreeState::Composite& all = state.composites().front();
  Centroid whole{.mass_kg = all.mass_kg};
  if (!(all.mass_kg > 0)) return whole;
  const Vector3d center_m = all.first_moment_kg_m / all.mass_kg;
  whole.position_m = state.base_origin_m() + center_m;
  whole.inertia_kg_m2 = all.inertia_kg_m2 + all.mass_kg * center_m * center_m.transpose();
  whole.inertia_kg_m2.diagonal().array() -= all.mass_kg * center_m.squaredNorm();
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyMotion& motion = state.motion(i);
    const RigidInertia& inertia = bodies[i].inertia;
    const Vector3d momentum_N_s = inertia.mass_kg * center_velocity_m_s(state, i);
    whole.velocity_m_s += momentum_N_s / all.mass_kg;
    whole.angular_momentum_Nm_s +=
        (motion.center_of_mass_m - center_m).cross(momentum_N_s) +
        motion.R_WB *
            (inertia.inertia_kg_m2 * (motion.R_WB.transpose() * motion.angular_velocity_rad_s));
    if (i > 0) whole.angular_momentum_Nm_s += spin_momentum_Nm_s(state, i);
  }
  whole.angular_velocity_rad_s = average_velocity(whole.inertia_kg_m2, whole.angular_momentum_Nm_s);
  return whole;
}

void centroidal_momentum_matrix(TreeState& state, MatrixOut out) {
  if (out.rows() != 6 || out.cols() != state.velocity().size()) {
    throw std::invalid_argument("centroidal momentum matrix: six rows, one column per velocity");
  }
  gather_composites(state);
  const TreeState::Composite& all = state.composites().front();
  const Vector3d center_m =
      all.mass_kg > 0 ? Vector3d(all.first_moment_kg_m / all.mass_kg) : Vector3d(Vector3d::Zero());
  for (Eigen::Index k = 0; k < state.tree().base_velocity_size(); ++k) {
    set_column(out, k, momentum_of(all, base_column(state, k)), center_m);
  }
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    Momentum momentum = momentum_of(state.composites()[i], joint_column(state, i));
    momentum.angular_Nm_s += state.motion(bodies[i].parent).R_WB * bodies[i].joint.rotor_spin_kg_m2;
    set_column(out, state.joint_row(i), momentum, center_m);
  }
}

double kinetic_energy_J(TreeState& state) {
  const std::vector<Body>& bodies = state.tree().bodies;
  double twice_J = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyMotion& motion = state.motion(i);
    const Vector3d w_B = motion.R_WB.transpose() * motion.angular_velocity_rad_s;
    twice_J += bodies[i].inertia.mass_kg * center_velocity_m_s(state, i).squaredNorm() +
               w_B.dot(bodies[i].inertia.inertia_kg_m2 * w_B);
    if (i == 0) continue;
    const double rate = state.joint_velocity(i);
    const Vector3d& carrier_rad_s = state.motion(bodies[i].parent).angular_velocity_rad_s;
    twice_J += bodies[i].joint.reflected_inertia * rate * rate +
               2 * spin_momentum_Nm_s(state, i).dot(carrier_rad_s);
  }
  return twice_J / 2;
}

double potential_energy_J(const TreeState& state) {
  double energy_J = 0;
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double height_m = state.base_origin_m().z() + state.motion(i).center_of_mass_m.z();
    energy_J += state.tree().gravity_m_s2 * bodies[i].inertia.mass_kg * height_m;
  }
  return energy_J;
}

}  // namespace torquewright::dynamics
