// SPDX-License-Identifier: Apache-2.0
// Oracle: the meaning of the signs. Torque along the speed pushes, against it brakes; mirrored in
// both signs, the sentence stays.
#include "actuator/drive_check/region_words.hpp"

#include <gtest/gtest.h>

namespace torquewright::actuator {
namespace {

std::string words(double speed_rad_s, double torque_Nm, std::optional<double> limit_Nm) {
  WorstSample sample;
  sample.speed_rad_s = speed_rad_s;
  sample.torque_Nm = torque_Nm;
  sample.limit_Nm = limit_Nm;
  return outside_words(sample);
}

void expect_both_ways(double speed_rad_s, double torque_Nm, double limit_Nm,
                      const std::string& sentence) {
  EXPECT_EQ(words(speed_rad_s, torque_Nm, limit_Nm), sentence);
  EXPECT_EQ(words(-speed_rad_s, -torque_Nm, -limit_Nm), sentence);
}

TEST(RegionWords, BeyondNoLoadSpeedTheDriveMustBrake) {
  expect_both_ways(11.8565, 311.998, -312.102,
                   "at 11.8565 rad/s the drive must brake with at least 312.102 Nm; it is asked to "
                   "push with 311.998 Nm");
  expect_both_ways(11.8565, -5.0, -312.102,
                   "at 11.8565 rad/s the drive must brake with at least 312.102 Nm; it is asked to "
                   "brake with 5 Nm");
  expect_both_ways(11.8565, 0.0, -312.102,
                   "at 11.8565 rad/s the drive must brake with at least 312.102 Nm; it is asked to "
                   "turn freely");
}

TEST(RegionWords, BelowItItCanPushAndBrakeAtMost) {
  expect_both_ways(8.7, 296.0, 192.4,
                   "at 8.7 rad/s the drive can push with at most 192.4 Nm; it is asked to push "
                   "with 296 Nm");
  expect_both_ways(8.7, -400.0, -320.0,
                   "at 8.7 rad/s the drive can brake with at most 320 Nm; it is asked to brake "
                   "with 400 Nm");
  expect_both_ways(8.7, -3.0, 0.5,
                   "at 8.7 rad/s the drive must push with at least 0.5 Nm; it is asked to brake "
                   "with 3 Nm");
}

TEST(RegionWords, AtRestNothingIsPushedOrBraked) {
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(words(0.0, sign * 25.0, sign * 20.0),
              "at rest the drive can hold at most 20 Nm; it is asked for 25 Nm");
  }
}

TEST(RegionWords, SayWhereThereIsNoTorqueAtAll) {
  EXPECT_EQ(words(-40.0, -25.0, {}),
            "at 40 rad/s the drive has no torque at all; it is asked to push with 25 Nm");
}

// Beyond a bound of zero, and where the region is empty: what it could by plugging is not denied.
TEST(RegionWords, SayThatTheSupplyTakesNothingBack) {
  for (const std::optional<double> limit_Nm :
       {std::optional<double>(0.0), std::optional<double>()}) {
    WorstSample sample;
    sample.speed_rad_s = 8.0;
    sample.torque_Nm = -30.0;
    sample.limit_Nm = limit_Nm;
    sample.limiter = Limiter::kRegeneration;
    EXPECT_EQ(outside_words(sample),
              "at 8 rad/s the drive may not brake: its supply takes nothing back, and plugging "
              "counts for nothing; it is asked to brake with 30 Nm");
    sample.limiter = Limiter::kVoltage;
    EXPECT_EQ(outside_words(sample).find("supply"), std::string::npos);
  }
}

}  // namespace
}  // namespace torquewright::actuator
