// SPDX-License-Identifier: Apache-2.0
// Oracle: decimals worked out by hand.
#include "io/text/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/text/shown_number.hpp"
#include "io/text/unit_scales.hpp"

namespace torquewright::io {
namespace {

TEST(NumberText, HasNoDigitsOfRounding) {
  EXPECT_EQ(known_text(319.99999999999994), "320");
  EXPECT_EQ(known_text(-2547.9999999997), "-2548");
  EXPECT_EQ(known_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(known_text(1e-20), "1e-20");  // alone it may be what it is
  EXPECT_EQ(known_text(-0.0), "0");
}

TEST(NumberText, EndsWhereItsColumnDoes) {
  EXPECT_EQ(known_text(8.29e-15, 320.0), "0");
  EXPECT_EQ(known_text(-4.2674634075448e-10, 3360.0), "0");
  EXPECT_EQ(known_text(1.23456e-8, 100.0), "1.2e-08");  // 100 is known to 1e-9
  EXPECT_EQ(known_text(7.0, 1e13), "0");
  EXPECT_EQ(known_text(77.0, 1e13), "100");
}

TEST(NumberText, KeepsWhatADecimalKeepsForOtherPrograms) {
  EXPECT_EQ(precise_text(0.012249999999999999), "0.01225");
  EXPECT_EQ(precise_text(-10.50000000000048), "-10.50000000000048");
  EXPECT_EQ(precise_text(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(precise_text(27.990000000000002), "27.99");
}

TEST(NumberText, LeavesNoNoiseAndAllDigits) {
  EXPECT_EQ(without_noise(8.29e-15, 320.0), 0.0);
  EXPECT_EQ(without_noise(1.4980985952435e-11, 42.0), 0.0);
  EXPECT_EQ(without_noise(1.4980985952435e-11, 0.001), 1.4980985952435e-11);
  EXPECT_EQ(without_noise(-6.67e-9, 800.0), 0.0);
  EXPECT_EQ(without_noise(-6.67e-8, 800.0), -6.67e-8);
  EXPECT_EQ(without_noise(0.1 + 0.2, 1.0), 0.1 + 0.2);
  EXPECT_TRUE(std::isnan(without_noise(std::nan(""), 1.0)));
}

TEST(NumberText, ShowsAPartBesideItsWhole) {
  EXPECT_EQ(shown(2.83e-05, 33.6, 3), 0.0);
  EXPECT_EQ(shown(-6.4912, 33.6, 3), -6.5);
  EXPECT_EQ(shown(33.04, 33.6, 3), 33.0);
}

// Columns of one unit have one scale, whatever they are called; "m" is not the end of "Nm".
TEST(NumberText, HasTheScaleOfItsUnit) {
  EXPECT_EQ(unit_of_name("base_momentum_y_Nm_s"), "Nm_s");
  EXPECT_EQ(unit_of_name("knee_torque_Nm"), "Nm");
  EXPECT_EQ(unit_of_name("time_s"), "s");
  EXPECT_EQ(unit_of_name("impact"), "");
  EXPECT_EQ(unit_scales({"front_force_x_N", "front_force_z_N", "knee_torque_Nm", "impact", "yes"},
                        {1e-14, 980.0, 33.0, 1.0, 2.0}),
            (std::vector<double>{980.0, 980.0, 33.0, 1.0, 2.0}));
}

TEST(NumberText, LeavesWhatIsNoNumber) {
  EXPECT_TRUE(std::isnan(known(std::nan(""))));
  EXPECT_EQ(known(HUGE_VAL, 3.0), HUGE_VAL);
  EXPECT_EQ(known(std::numeric_limits<double>::denorm_min()),
            std::numeric_limits<double>::denorm_min());
}

}  // namespace
}  // namespace torquewright::io
