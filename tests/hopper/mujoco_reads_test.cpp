// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo itself, which reads the file that we write.
#include <gtest/gtest.h>

#include "dynamics/mass_matrix.hpp"
#include "hopper/files/mjcf_writer.hpp"
#include "hopper/files/rotors_in_joints.hpp"
#include "hopper/robot/robot_spec.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/tree_mjcf.hpp"
#include "tests/hopper/same_robot.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Worst relative difference of mass matrices over some states.
double mass_difference(const Robot& robot) {
  test::MujocoEngine mujoco(mjcf_of(robot).text);
  const std::vector<Eigen::Index> rows = test::rows_of_mujoco(robot.tree);
  dynamics::TreeState state(robot.tree);
  const Eigen::Index size = robot.tree.velocity_size();
  oracles::Dice dice(12);
  double worst = 0;
  for (int sample = 0; sample < 50; ++sample) {
    const VectorXd q = test::random_position(dice, robot.tree);
    const VectorXd v = VectorXd::Zero(size);
    VectorXd theirs = q;
    const Eigen::Index base = robot.tree.base_velocity_size();
    const Eigen::Index extra = q.size() - size;
    for (Eigen::Index i = base; i < size; ++i) {
      theirs[i + extra] = q[rows[static_cast<std::size_t>(i)] + extra];
    }
    state.set(q, v);
    mujoco.set(theirs, v);
    MatrixXd mass(size, size);
    MatrixXd swapped(size, size);
    dynamics::mass_matrix(state, mass);
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 0; j < size; ++j) {
        swapped(i, j) = mass(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
      }
    }
    worst = std::max(worst, test::difference(swapped, mujoco.mass_matrix()));
  }
  return worst;
}

TEST(ExportedMjcf, HasOurMassMatrixInMujoco) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    oracles::Dice dice(seed);
    const auto base = static_cast<dynamics::BaseKind>(seed % 3);
    EXPECT_LE(mass_difference(test::random_robot(dice, base)), 1e-9) << seed;
  }
  for (const char* name : {"hopper", "rabbit"}) {
    const std::string file = std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/") + name + ".json";
    Robot robot = read_robot(file).robot;
    // What the file holds of rotors behind linkages, which have their own test.
    std::vector<std::string> notes;
    robot.tree = tree_with_rotors(robot, notes);
    robot.drivetrains.clear();
    EXPECT_LE(mass_difference(robot), 1e-9) << name;
  }
}

}  // namespace
}  // namespace torquewright::hopper
