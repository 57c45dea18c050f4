// SPDX-License-Identifier: Apache-2.0
// Oracle: ranges worked out by hand in the comments.
#include <gtest/gtest.h>

#include "hopper/trials/eased.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kLastPlace = 1e-15;

void expect_range(const std::optional<Range>& range, double least, double greatest) {
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->least, least, kLastPlace);
  EXPECT_NEAR(range->greatest, greatest, kLastPlace);
}

TEST(EasedRandomisation, ShrinksTowardsTheDocumentAndLeavesTheSupplyAlone) {
  const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  Randomisation whole =
      read_randomisation(TORQUEWRIGHT_SOURCE_DIR "/specs/randomisation/hopper.json").randomisation;
  whole.motor_strength_factor = {{{0.8, 1.1}, {}, ""}};
  const Randomisation half = eased(whole, robot, 0.5);
  expect_range(half.total_mass_factor, 0.925, 1.075);   // 0.85 to 1.15 about 1
  expect_range(half.friction_coefficient, 0.55, 0.75);  // 0.5 to 0.9 about the contacts' 0.6
  expect_range(half.restitution, 0.0, 0.1);             // 0 to 0.2 about 0
  expect_range(half.center_of_mass_shift_m.front().of_bodies.range, -0.015, 0.015);
  expect_range(half.further_friction_Nm.front().range, 0.0, 0.35);
  expect_range(half.motor_strength_factor.front().range, 0.9, 1.05);
  expect_range(half.bus_voltage_factor, 0.93, 1.0);
  EXPECT_NEAR(half.noise.joint_velocity_rad_s, 0.25, kLastPlace);
  const Randomisation none = eased(whole, robot, 0.0);
  expect_range(none.total_mass_factor, 1.0, 1.0);
  expect_range(none.friction_coefficient, 0.6, 0.6);
  expect_range(none.bus_voltage_factor, 0.93, 1.0);
  EXPECT_EQ(none.noise.gravity_direction, 0.0);
  expect_range(eased(whole, robot, 1.0).total_mass_factor, 0.85, 1.15);
}

}  // namespace
}  // namespace torquewright::hopper
