// SPDX-License-Identifier: Apache-2.0
// Oracle: a counter under malloc and new.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "dynamics/seeds.hpp"
#include "tests/dynamics/allocation_count.hpp"
#include "tests/dynamics/random_arm.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::allocation_count;

TEST(AllocationCount, CountsEigenAndTheStandardLibrary) {
  const long before = allocation_count();
  const MatrixXd matrix = MatrixXd::Random(9, 9);
  EXPECT_GT(allocation_count(), before);
  const long between = allocation_count();
  const std::vector<double> numbers(100, matrix(0, 0));
  EXPECT_GT(allocation_count(), between) << numbers[0];
}

TEST(SerialArm, NeverAllocatesOnceItStands) {
  oracles::Dice dice(81);
  dynamics::SerialArm arm = test::random_arm(dice, 4);
  const VectorXd q = test::uniform_vector(dice, 4, 4);
  VectorXd out(4);
  MatrixXd mass(4, 4);
  MatrixXd columns(4, 12);
  const long before = allocation_count();
  arm.regressor(q, q, q, columns);
  arm.inverse_dynamics(q, q, q, out);
  arm.bias(q, q, out);
  arm.mass_matrix(q, mass);
  const double energy_J = arm.kinetic_energy_J(q, q) + arm.potential_energy_J(q);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_TRUE(std::isfinite(energy_J));
}

TEST(TreeState, NeverAllocatesOnceItStands) {
  oracles::Dice dice(82);
  const dynamics::Tree tree = test::random_tree(dice, dynamics::BaseKind::kSpatial, 12);
  dynamics::TreeState state(tree);
  const VectorXd v = test::uniform_vector(dice, 18, 4);
  VectorXd q = test::random_position(dice, tree);
  VectorXd out(18);
  MatrixXd mass(18, 18);
  MatrixXd momentum(6, 18);
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, 18);
  const dynamics::BodyPoint point{12, {0.1, 0.2, 0.3}};
  const long before = allocation_count();
  dynamics::step_position(tree, q, v, 0.1, q);
  state.set(q, v);
  dynamics::inverse_dynamics(state, v, out);
  dynamics::bias(state, out);
  dynamics::mass_matrix(state, mass);
  const bool solved = dynamics::forward_dynamics(state, v, out);
  dynamics::centroidal_momentum_matrix(state, momentum);
  dynamics::point_jacobian(state, point, jacobian);
  dynamics::rotation_jacobian(state, 12, jacobian);
  dynamics::add_point_force(state, point, {1, 2, 3}, out);
  const double height_m = dynamics::point_position_m(state, point).z() +
                          dynamics::point_bias_acceleration_m_s2(state, point).z() +
                          dynamics::centroid(state).position_m.z();
  const double energy_J = dynamics::kinetic_energy_J(state) + dynamics::potential_energy_J(state);
  EXPECT_EQ(allocation_count(), before);
  EXPECT_TRUE(solved) << energy_J << height_m;
}

TEST(TreeState, NeverAllocatesForNumbersWithDerivatives) {
  using dynamics::Jet2;
  oracles::Dice dice(83);
  const dynamics::Tree tree = test::random_tree(dice, dynamics::BaseKind::kSpatial, 3);
  dynamics::TreeStateOf<Jet2> state(tree);
  const auto q = dynamics::seeded_position<Jet2>(tree, test::random_position(dice, tree), 0);
  const auto v = dynamics::seeded<Jet2>(test::uniform_vector(dice, 9, 4), 9);
  dynamics::VectorX<Jet2> out(9);
  Eigen::Matrix<Jet2, Eigen::Dynamic, Eigen::Dynamic> mass(9, 9);
  const long before = allocation_count();
  state.set(q, v);
  dynamics::inverse_dynamics(state, v, out);
  dynamics::add_point_force(state, {3, {0.1, 0.2, 0.3}}, {1, 2, 3}, out);
  dynamics::mass_matrix(state, mass);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace torquewright
