// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo's forward kinematics of the same trees, which turn and slide about any axis.
#include <gtest/gtest.h>

#include <cmath>

#include "src/report/turning/body_poses.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/dynamics/tree_mjcf.hpp"

namespace torquewright::report {
namespace {

using Eigen::VectorXd;

constexpr double kPlace = 1e-6;  // a float's rounding, of how far away it is
// Four parts rounded by half a part each: a quaternion off by one part, a turn by two, a matrix's
// norm by the root of two times that.
const double kTurn = 2.0 * std::sqrt(2.0) / kWholeTurn;

/// In MuJoCo's order of the joints.
VectorXd theirs(const dynamics::Tree& tree, const VectorXd& position) {
  VectorXd ordered = position;
  const auto rows = test::rows_of_mujoco(tree);
  const auto size = tree.velocity_size();
  for (Eigen::Index i = 0; i < size; ++i) {
    ordered[position.size() - size + i] =
        position[position.size() - size + rows[static_cast<std::size_t>(i)]];
  }
  if (position.size() > size) ordered.head<7>() = position.head<7>();
  return ordered;
}

TEST(BodyPoses, AreWhereMujocoHasThem) {
  oracles::Dice dice(49);
  for (int i = 0; i < 20; ++i) {
    hopper::Robot robot;
    robot.tree = test::random_tree(dice, dynamics::BaseKind::kSpatial, 9);
    test::MujocoEngine mujoco(test::mjcf_of(robot.tree));
    Eigen::MatrixXd positions(robot.tree.position_size(), 4);
    for (auto column : positions.colwise()) column = test::random_position(dice, robot.tree);
    const BodyPoses poses = body_poses(robot, positions);
    for (Eigen::Index at = 0; at < positions.cols(); ++at) {
      mujoco.set(theirs(robot.tree, positions.col(at)), VectorXd::Zero(mujoco.nv()));
      for (std::size_t body = 0; body < robot.tree.bodies.size(); ++body) {
        const int id =
            mj_name2id(&mujoco.model(), mjOBJ_BODY, robot.tree.bodies[body].name.c_str());
        ASSERT_GT(id, 0);
        const Eigen::Map<const Eigen::Vector3d> place(mujoco.data().xpos + 3 * id);
        const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(
            mujoco.data().xmat + 9 * id);
        EXPECT_LT((poses.place_m(body, at) - place).norm(), kPlace * (1.0 + place.norm()));
        EXPECT_LT((poses.rotation(body, at) - rotation).norm(), kTurn);
      }
      EXPECT_LT((poses.center_of_mass_m(at) - mujoco.center_of_mass_m()).norm(),
                kPlace * (1.0 + mujoco.center_of_mass_m().norm()));
    }
  }
}

}  // namespace
}  // namespace torquewright::report
