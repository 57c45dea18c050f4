// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo, which knows bodies in space and nothing of our regressor.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/random_arm.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kStates = 10000;
constexpr double kRelative = 1e-9;

std::string mjcf_of(const SerialArm& arm) {
  std::string opening;
  std::string closing;
  double above_m = 0;
  for (const SerialLink& link : arm.links()) {
    opening += fmt::format(R"(<body pos="0 0 {0}"><joint type="hinge" axis="0 -1 0"/>)"
                           R"(<inertial pos="0 0 {1}" mass="{2}" diaginertia="{3} {3} {3}"/>)",
                           -above_m, -link.center_of_mass_m, link.mass_kg, link.inertia_kg_m2);
    closing += "</body>";
    above_m = link.length_m;
  }
  return R"(<mujoco><compiler angle="radian"/><option gravity="0 0 -9.81"/>)"
         R"(<worldbody>)" +
         opening + closing + "</worldbody></mujoco>";
}

TEST(SerialArm, AgreesWithMujoco) {
  oracles::Dice dice(71);
  double worst_mass = 0;
  double worst_bias = 0;
  double worst_torque = 0;
  for (int model = 0; model < 20; ++model) {
    const Eigen::Index n = 1 + model % 5;
    SerialArm arm = test::random_arm(dice, n);
    test::MujocoEngine mujoco(mjcf_of(arm));
    MatrixXd mass(n, n);
    VectorXd bias(n);
    VectorXd torque(n);
    for (int state = 0; state < kStates / 20; ++state) {
      const VectorXd q = test::uniform_vector(dice, n, 7);
      const VectorXd v = test::uniform_vector(dice, n, 15);
      const VectorXd a = test::uniform_vector(dice, n, 100);
      mujoco.set(q, v);
      arm.mass_matrix(q, mass);
      arm.bias(q, v, bias);
      arm.inverse_dynamics(q, v, a, torque);
      worst_mass = std::max(worst_mass, test::difference(mass, mujoco.mass_matrix()));
      worst_bias = std::max(worst_bias, test::difference(bias, mujoco.bias()));
      worst_torque = std::max(worst_torque, test::difference(torque, mujoco.inverse_dynamics(a)));
    }
  }
  std::printf("worst of %d states: mass matrix %.2g, bias %.2g, inverse dynamics %.2g\n", kStates,
              worst_mass, worst_bias, worst_torque);
  EXPECT_LE(worst_mass, kRelative);
  EXPECT_LE(worst_bias, kRelative);
  EXPECT_LE(worst_torque, kRelative);
}

}  // namespace
}  // namespace torquewright::dynamics
