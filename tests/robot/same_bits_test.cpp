// SPDX-License-Identifier: Apache-2.0
// The double version of mechanisms and whole bodies, which are written for any scalar. Oracle: the
// same functions as they were when they knew no scalar but double; the sums below were printed by
// these tests at the commit before they became templates. An intended change of their rounding has
// to state new sums and why.
#include <gtest/gtest.h>

#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/mechanisms/four_bar.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/whole_body.hpp"
#include "tests/dynamics/bit_sum.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/robot/mechanisms/ankles.hpp"
#include "tests/robot/mechanisms/four_bars.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using oracles::Dice;
using test::BitSum;
using test::uniform;
using test::uniform_vector;

constexpr std::uint64_t kMechanismBits = 0xd93f47154cdc3602;
constexpr std::uint64_t kWholeBodyBits = 0x1d20176ed3dbd50a;

void add(const Mechanism& mechanism, const SmallVector& q, const SmallVector& v, BitSum& bits) {
  const auto at = mechanism.transfer(q, v);
  bits.add(at ? 1.0 : 0.0);
  if (at) {
    bits.add(at->actuator_position_rad);
    bits.add(at->jacobian);
    bits.add(at->jacobian_rate_1_s);
    bits.add(joint_torque_Nm(*at, v));
    bits.add(actuator_torque_Nm(*at, v));
    bits.add(reflected_inertia_kg_m2(*at, v));
    bits.add(rotor_torque_Nm(*at, v, q, v));
  }
  for (const MechanismMargin& margin : mechanism.margins(q)) {
    bits.add(margin.value);
    bits.add(margin.margin);
  }
}

FourBarGeometry any_four_bar(Dice& dice) {
  FourBarGeometry links;
  do {
    links.crank_m = uniform(dice, 0.1, 2);
    links.coupler_m = uniform(dice, 0.1, 2);
    links.rocker_m = dice.chance(20) ? links.crank_m : uniform(dice, 0.1, 2);
    links.ground_m = dice.chance(20) ? links.coupler_m : uniform(dice, 0.1, 2);
  } while (four_bar_objection(links));
  test::mount_anyhow(dice, links);
  return links;
}

TEST(SameBitsOfTheHopper, InItsMechanisms) {
  if (!test::is_stored_library()) GTEST_SKIP() << test::kOtherLibrary << test::library_bits();
  Dice dice(2027);
  BitSum bits;
  for (int i = 0; i < 2000; ++i) {
    add(FourBar(any_four_bar(dice)), uniform_vector(dice, 1, 3), uniform_vector(dice, 1, 3), bits);
    const SmallVector q = uniform_vector(dice, 2, 0.8), v = uniform_vector(dice, 2, 9);
    add(ParallelAnkle(test::askew_ankle(dice)), q, v, bits);
    const MatrixXd jacobian = MatrixXd::Identity(2, 2) + uniform_vector(dice, 2, 1) * v.transpose();
    add(ConstantJacobian("parallel", jacobian), q, v, bits);
  }
  EXPECT_EQ(bits.value(), kMechanismBits) << std::hex << bits.value();
}

TEST(SameBitsOfTheHopper, InTheWholeBody) {
  if (!test::is_stored_library()) GTEST_SKIP() << test::kOtherLibrary << test::library_bits();
  const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  WholeBody body(robot);
  const Eigen::Index n = robot.tree.velocity_size();
  Dice dice(2028);
  BitSum bits;
  for (int i = 0; i < 1000; ++i) {
    VectorXd q = test::random_position(dice, robot.tree);
    q.tail(3) << uniform(dice, 0.2, 2), uniform(dice, -0.5, 0.5), uniform(dice, -0.3, 0.3);
    bits.add(body.set(q, uniform_vector(dice, n, 9)) ? 1.0 : 0.0);
    const VectorXd a = uniform_vector(dice, n, 50);
    VectorXd force(n), torque(static_cast<Eigen::Index>(body.drive_count()));
    MatrixXd mass(n, n);
    body.mass_matrix(mass);
    bits.add(mass);
    body.inverse_dynamics(a, force);
    bits.add(force);
    body.at_actuators(force, torque);
    bits.add(torque);
    body.speed_changes(a, torque);
    bits.add(torque);
    std::vector<DriveInstant> drives;
    body.drives(a, force, drives);
    for (const DriveInstant& drive : drives) bits.add(drive.torque_Nm);
  }
  EXPECT_EQ(bits.value(), kWholeBodyBits) << std::hex << bits.value();
}

}  // namespace
}  // namespace torquewright::hopper
