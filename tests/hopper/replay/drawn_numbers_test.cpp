// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/drawn_numbers.hpp"

#include <gtest/gtest.h>

#include "tests/hopper/replay/randomised_hopper.hpp"

namespace torquewright::hopper {
namespace {

using test::hopper;
using test::seeds_tables;

std::vector<DrawnNumber> shown(const Randomisation& randomisation) {
  return drawn_numbers(draw_trial(randomisation, hopper(), 2, 9), randomisation, hopper());
}

double value_of(const std::vector<DrawnNumber>& list, const std::string& quantity,
                const std::string& of) {
  for (const DrawnNumber& number : list) {
    if (number.quantity == quantity && number.of == of) return number.value;
  }
  ADD_FAILURE() << "no " << quantity << " of " << of;
  return 0.0;
}

// Oracle: the document, counted by hand (4 masses, 4 inertias, 3 times 3 shifts, 3 gains, 3
// frictions, ground's 2, voltage, winding), and the trial itself.
TEST(DrawnNumbers, AreThoseOfTheDocument) {
  const std::vector<DrawnNumber> list = shown(seeds_tables());
  EXPECT_EQ(list.size(), 4u + 4u + 9u + 3u + 3u + 2u + 1u + 1u);
  const Trial trial = draw_trial(seeds_tables(), hopper(), 2, 9);
  EXPECT_EQ(value_of(list, "mass_factor", "foot"), trial.mass_factor[3]);
  EXPECT_EQ(value_of(list, "body_inertia_factor", "calf"), trial.inertia_factor[1]);
  EXPECT_EQ(value_of(list, "center_of_mass_shift_m", "foot y"), trial.center_of_mass_shift_m(1, 3));
  EXPECT_EQ(value_of(list, "further_friction_Nm", "ankle_right"), trial.further_friction_Nm[2]);
  EXPECT_EQ(value_of(list, "controller_gain_factor", "knee"), trial.controller_gain_factor[0]);
  EXPECT_EQ(value_of(list, "restitution", ""), trial.restitution);
  EXPECT_EQ(value_of(list, "bus_voltage_factor", ""), trial.bus_voltage_factor);
}

TEST(DrawnNumbers, LeaveOutWhatNothingDraws) {
  EXPECT_TRUE(shown({}).empty());
  Randomisation few;
  few.body_mass_factor = {{{0.9, 1.1}, {"calf"}, ""}};
  few.center_of_mass_shift_m = {{{{0.0, 0.1}, {"foot"}, ""}, {false, false, true}}};
  few.motor_strength_factor = {{{0.9, 1.1}, {"ankle_left"}, ""}};
  few.latency_s = Range{0.0, 0.002};
  few.ground_height_m = Range{-0.01, 0.01};
  few.initial_joint_velocity_rad_s = {{{0.0, 0.5}, {"ankle_roll"}, ""}};
  std::vector<std::string> names;
  for (const DrawnNumber& number : shown(few)) names.push_back(number.quantity + "/" + number.of);
  EXPECT_EQ(names,
            (std::vector<std::string>{"mass_factor/calf", "center_of_mass_shift_m/foot z",
                                      "motor_strength_factor/ankle_left", "ground_height_m/",
                                      "latency_s/", "initial_joint_velocity_rad_s/ankle_roll"}));
}

}  // namespace
}  // namespace torquewright::hopper
