// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/momentum.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "dynamics/composite.hpp"
#include "dynamics/jet.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Inertias below this share of the largest are those of needles and points: no turn about them.
constexpr double kNoInertia = 1e-14;

template <typename T>
Vector3<T> center_velocity_m_s(const TreeStateOf<T>& state, std::size_t body) {
  const BodyMotionOf<T>& motion = state.motion(body);
  return motion.velocity_m_s +
         motion.angular_velocity_rad_s.cross(motion.center_of_mass_m - motion.origin_m);
}

template <typename T>
Vector3<T> spin_momentum_Nm_s(const TreeStateOf<T>& state, std::size_t body) {
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

template <typename T>
void set_column(MatrixOutOf<T>& out, Eigen::Index column, const MomentumOf<T>& momentum,
                const Vector3<T>& center_m) {
  out.col(column).template head<3>() = momentum.angular_Nm_s - center_m.cross(momentum.linear_N_s);
  out.col(column).template tail<3>() = momentum.linear_N_s;
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

template <typename T>
void centroidal_momentum_matrix(TreeStateOf<T>& state, MatrixOutOf<T> out) {
  if (out.rows() != 6 || out.cols() != state.velocity().size()) {
    throw std::invalid_argument("centroidal momentum matrix: six rows, one column per velocity");
  }
  gather_composites(state);
  const typename TreeStateOf<T>::Composite& all = state.composites().front();
  const Vector3<T> center_m = all.mass_kg > 0 ? Vector3<T>(all.first_moment_kg_m / all.mass_kg)
                                              : Vector3<T>(Vector3<T>::Zero());
  for (Eigen::Index k = 0; k < state.tree().base_velocity_size(); ++k) {
    set_column<T>(out, k, momentum_of<T>(all, base_column(state, k)), center_m);
  }
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    MomentumOf<T> momentum = momentum_of<T>(state.composites()[i], joint_column(state, i));
    momentum.angular_Nm_s += state.motion(bodies[i].parent).R_WB * bodies[i].joint.rotor_spin_kg_m2;
    set_column<T>(out, state.joint_row(i), momentum, center_m);
  }
}

template <typename T>
T kinetic_energy_J(TreeStateOf<T>& state) {
  const std::vector<Body>& bodies = state.tree().bodies;
  T twice_J = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyMotionOf<T>& motion = state.motion(i);
    const Vector3<T> w_B = motion.R_WB.transpose() * motion.angular_velocity_rad_s;
    twice_J += bodies[i].inertia.mass_kg * center_velocity_m_s(state, i).squaredNorm() +
               w_B.dot(bodies[i].inertia.inertia_kg_m2 * w_B);
    if (i == 0) continue;
    const T& rate = state.joint_velocity(i);
    const Vector3<T>& carrier_rad_s = state.motion(bodies[i].parent).angular_velocity_rad_s;
    twice_J += bodies[i].joint.reflected_inertia * rate * rate +
               2 * spin_momentum_Nm_s(state, i).dot(carrier_rad_s);
  }
  return twice_J / 2;
}

template <typename T>
T potential_energy_J(const TreeStateOf<T>& state) {
  T energy_J = 0;
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const T height_m = state.base_origin_m().z() + state.motion(i).center_of_mass_m.z();
    energy_J += state.tree().gravity_m_s2 * bodies[i].inertia.mass_kg * height_m;
  }
  return energy_J;
}

template void centroidal_momentum_matrix(TreeState&, MatrixOutOf<double>);
template double kinetic_energy_J(TreeState&);
template double potential_energy_J(const TreeState&);
template void centroidal_momentum_matrix(TreeStateOf<Jet>&, MatrixOutOf<Jet>);
template Jet kinetic_energy_J(TreeStateOf<Jet>&);
template Jet potential_energy_J(const TreeStateOf<Jet>&);
template void centroidal_momentum_matrix(TreeStateOf<Jet2>&, MatrixOutOf<Jet2>);
template Jet2 kinetic_energy_J(TreeStateOf<Jet2>&);
template Jet2 potential_energy_J(const TreeStateOf<Jet2>&);

}  // namespace torquewright::dynamics
