// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo on the same trees.
#include <gtest/gtest.h>

#include <map>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/dynamics/tree_mjcf.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using oracles::Dice;
using test::difference;

constexpr double kTreeRelative = 1e-9;
constexpr int kTreesPerBase = 12;
constexpr int kStatesPerTree = 300;  // of all trees more than 1e4

struct Worst {
  std::map<std::string, double> of;
  template <typename A, typename B>
  void see(const std::string& quantity, const A& ours, const B& theirs) {
    of[quantity] = std::max(of[quantity], difference(ours, theirs));
  }
};

/// A tree of ours beside MuJoCo's, rows of velocity reordered.
class Pair {
 public:
  explicit Pair(const Tree& tree)
      : state_(tree), mujoco_(test::mjcf_of(tree)), rows_(test::rows_of_mujoco(tree)) {}

  void compare(Dice& dice, Worst& worst) {
    const Tree& tree = state_.tree();
    const Eigen::Index size = tree.velocity_size();
    const VectorXd q = test::random_position(dice, tree);
    const VectorXd v = test::uniform_vector(dice, size, 12);
    const VectorXd a = test::uniform_vector(dice, size, 80);
    state_.set(q, v);
    const Eigen::Index extra = q.size() - size;
    VectorXd their_q = q;
    their_q.tail(size) = theirs(q.tail(size));
    if (extra == 1) their_q.head<7>() = q.head<7>();
    mujoco_.set(their_q, theirs(v));

    MatrixXd mass(size, size);
    VectorXd force(size);
    mass_matrix(state_, mass);
    MatrixXd permuted(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 0; j < size; ++j) {
        permuted(i, j) = mass(rows_[std::size_t(i)], rows_[std::size_t(j)]);
      }
    }
    worst.see("mass matrix", permuted, mujoco_.mass_matrix());
    bias(state_, force);
    worst.see("bias", theirs(force), mujoco_.bias());
    const Centroid whole = centroid(state_);
    worst.see("centre of mass", whole.position_m, mujoco_.center_of_mass_m());
    worst.see("CAM", whole.angular_momentum_Nm_s, mujoco_.angular_momentum_Nm_s());
    worst.see("energy", Eigen::Vector2d(kinetic_energy_J(state_), potential_energy_J(state_)),
              Eigen::Vector2d(mujoco_.kinetic_energy_J(), mujoco_.potential_energy_J()));
    inverse_dynamics(state_, a, force);
    worst.see("inverse dynamics", theirs(force), mujoco_.inverse_dynamics(theirs(a)));
  }

 private:
  VectorXd theirs(const VectorXd& ours) const {
    VectorXd result(ours.size());
    for (Eigen::Index i = 0; i < ours.size(); ++i) result[i] = ours[rows_[std::size_t(i)]];
    return result;
  }

  TreeState state_;
  test::MujocoEngine mujoco_;
  std::vector<Eigen::Index> rows_;
};

class TreeBeside : public testing::TestWithParam<BaseKind> {};

TEST_P(TreeBeside, MujocoAgrees) {
  Dice dice(91);
  Worst worst;
  for (int tree = 0; tree < kTreesPerBase; ++tree) {
    Pair pair(test::random_tree(dice, GetParam(), 1 + static_cast<std::size_t>(tree)));
    for (int state = 0; state < kStatesPerTree; ++state) pair.compare(dice, worst);
  }
  for (const auto& [quantity, value] : worst.of) {
    std::printf("worst of %d states: %s %.2g\n", kTreesPerBase * kStatesPerTree, quantity.c_str(),
                value);
    EXPECT_LE(value, kTreeRelative) << quantity;
  }
  EXPECT_EQ(worst.of.size(), 6U);
}

INSTANTIATE_TEST_SUITE_P(Bases, TreeBeside,
                         testing::Values(BaseKind::kFixed, BaseKind::kPlanar, BaseKind::kSpatial));

}  // namespace
}  // namespace torquewright::dynamics
