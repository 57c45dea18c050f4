// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/mass_matrix.hpp"

#include <Eigen/Cholesky>
#include <stdexcept>

#include "dynamics/composite.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/jet.hpp"

namespace torquewright::dynamics {
namespace {

template <typename T>
T along(const ColumnOf<T>& column, const MomentumOf<T>& momentum) {
  return column.angular.dot(momentum.angular_Nm_s) + column.linear.dot(momentum.linear_N_s);
}

template <typename T>
void set_both(MatrixOutOf<T>& out, Eigen::Index row, Eigen::Index column, const T& value) {
  out(row, column) = value;
  out(column, row) = value;
}

/// Row and column of one joint: itself, the joints before it, the base; eq. (12).
template <typename T>
void fill_joint(const TreeStateOf<T>& state, std::size_t index,
                const typename TreeStateOf<T>::Composite& composite, MatrixOutOf<T>& out) {
  const std::vector<Body>& bodies = state.tree().bodies;
  const Joint& joint = bodies[index].joint;
  const Eigen::Index row = state.joint_row(index);
  const ColumnOf<T> own = joint_column(state, index);
  MomentumOf<T> momentum = momentum_of<T>(composite, own);
  out(row, row) = along(own, momentum) + joint.reflected_inertia;
  std::size_t before = bodies[index].parent;
  momentum.angular_Nm_s += state.motion(before).R_WB * joint.rotor_spin_kg_m2;
  for (; before > 0; before = bodies[before].parent) {
    set_both<T>(out, row, state.joint_row(before), along(joint_column(state, before), momentum));
  }
  for (Eigen::Index k = 0; k < state.tree().base_velocity_size(); ++k) {
    set_both<T>(out, row, k, along(base_column(state, k), momentum));
  }
}

}  // namespace

template <typename T>
void mass_matrix(TreeStateOf<T>& state, MatrixOutOf<T> out) {
  const Eigen::Index size = state.velocity().size();
  if (out.rows() != size || out.cols() != size) {
    throw std::invalid_argument("mass matrix: one row and column per velocity");
  }
  gather_composites(state);
  out.setZero();
  const Eigen::Index base_size = state.tree().base_velocity_size();
  for (Eigen::Index k = 0; k < base_size; ++k) {
    const MomentumOf<T> momentum =
        momentum_of<T>(state.composites().front(), base_column(state, k));
    for (Eigen::Index j = 0; j <= k; ++j) {
      set_both<T>(out, k, j, along(base_column(state, j), momentum));
    }
  }
  for (std::size_t i = 1; i < state.tree().bodies.size(); ++i) {
    fill_joint<T>(state, i, state.composites()[i], out);
  }
}

bool forward_dynamics(TreeState& state, const VectorIn& force, VectorOut acceleration) {
  require_velocity_size(state, force.size());
  require_velocity_size(state, acceleration.size());
  Eigen::MatrixXd& matrix = state.matrix_scratch();
  mass_matrix(state, matrix);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors(matrix);  // in place
  if (factors.info() != Eigen::Success) return false;
  Eigen::VectorXd& solution = state.solution_scratch();
  bias(state, solution);
  solution = force - solution;
  factors.solveInPlace(solution);
  acceleration = solution;
  return true;
}

template void mass_matrix(TreeState&, MatrixOutOf<double>);
template void mass_matrix(TreeStateOf<Jet>&, MatrixOutOf<Jet>);
template void mass_matrix(TreeStateOf<Jet2>&, MatrixOutOf<Jet2>);

}  // namespace torquewright::dynamics
