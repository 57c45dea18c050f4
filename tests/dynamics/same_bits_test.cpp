// SPDX-License-Identifier: Apache-2.0
// The double version of what is written for any scalar. Oracle: the same functions as they were
// when they knew no scalar but double; the sum below was printed by this test at the commit before
// they became templates. An intended change of their rounding has to state a new sum and why.
#include <gtest/gtest.h>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "tests/dynamics/bit_sum.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::BitSum;
using test::uniform_vector;

constexpr std::uint64_t kDynamicsBits = 0xb0c571d490787f50;

Tree spun_tree(oracles::Dice& dice, BaseKind base) {
  Tree tree = test::random_tree(dice, base, static_cast<std::size_t>(dice.between(1, 12)));
  for (Body& body : tree.bodies) {
    if (dice.chance(50)) body.joint.rotor_spin_kg_m2 = uniform_vector(dice, 3, 0.05);
  }
  return tree;
}

void add_forces(TreeState& state, const VectorXd& a, BitSum& bits) {
  const Eigen::Index n = a.size();
  VectorXd force = VectorXd::Zero(n);
  inverse_dynamics(state, a, force);
  bits.add(force);
  bias(state, force);
  bits.add(force);
  MatrixXd mass(n, n);
  mass_matrix(state, mass);
  bits.add(mass);
  VectorXd found = VectorXd::Zero(n);
  bits.add(forward_dynamics(state, force + a, found) ? 1.0 : 0.0);
  bits.add(found);
}

void add_points(const TreeState& state, const BodyPoint& point, BitSum& bits) {
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, state.velocity().size());
  point_jacobian(state, point, jacobian);
  bits.add(jacobian);
  rotation_jacobian(state, point.body, jacobian);
  bits.add(jacobian);
  bits.add(point_position_m(state, point));
  bits.add(point_velocity_m_s(state, point));
  bits.add(point_bias_acceleration_m_s2(state, point));
  VectorXd force = VectorXd::Ones(state.velocity().size());
  add_point_force(state, point, {3, -5, 70}, force);
  bits.add(force);
}

void add_momenta(TreeState& state, BitSum& bits) {
  const Centroid whole = centroid(state);
  bits.add(whole.position_m);
  bits.add(whole.angular_momentum_Nm_s);
  bits.add(whole.inertia_kg_m2);
  bits.add(whole.angular_velocity_rad_s);
  MatrixXd matrix(6, state.velocity().size());
  centroidal_momentum_matrix(state, matrix);
  bits.add(matrix);
  bits.add(kinetic_energy_J(state));
  bits.add(potential_energy_J(state));
}

TEST(SameBits, OfTheDynamicsInDouble) {
  if (!test::is_stored_library()) GTEST_SKIP() << test::kOtherLibrary << test::library_bits();
  oracles::Dice dice(2026);
  BitSum bits;
  for (int i = 0; i < 90; ++i) {
    const Tree tree = spun_tree(dice, static_cast<BaseKind>(i % 3));
    TreeState state(tree);
    for (int k = 0; k < 12; ++k) {
      const VectorXd q = test::random_position(dice, tree);
      const VectorXd v = uniform_vector(dice, tree.velocity_size(), 10);
      state.set(q, v);
      add_forces(state, uniform_vector(dice, tree.velocity_size(), 50), bits);
      const auto body = static_cast<std::size_t>(
          dice.between(0, static_cast<std::int64_t>(tree.bodies.size()) - 1));
      add_points(state, {body, Vector3d(uniform_vector(dice, 3, 1))}, bits);
      add_momenta(state, bits);
      VectorXd there(q.size()), difference(v.size());
      step_position(tree, q, v, 0.013, there);
      position_difference(tree, q, there, difference);
      bits.add(there);
      bits.add(difference);
    }
  }
  EXPECT_EQ(bits.value(), kDynamicsBits) << std::hex << bits.value();
}

}  // namespace
}  // namespace torquewright::dynamics
