// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/common_convention.hpp"

#include <gtest/gtest.h>

#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

/// Kt 0.125, 24 V and the ratio: what c times V / (Kt N) is.
Actuator with_speed(double ratio, double speed_rad_s) {
  Actuator document = sample();
  document.transmission.ratio = ratio;
  document.datasheet->no_load_speed_rad_s = speed_rad_s;
  return document;
}

TEST(CommonFactor, NeedsTwoSpeeds) {
  EXPECT_FALSE(common_factor(std::vector{with_speed(10, 19.2)}));
  EXPECT_FALSE(common_factor(std::vector{with_speed(10, 19.2), sample()}));
}

TEST(CommonFactor, IsSilentWhereOneConventionFitsAll) {
  const auto common = common_factor(std::vector{with_speed(10, 19.2), with_speed(20, 9.6)});
  ASSERT_TRUE(common);
  EXPECT_TRUE(common->is_common_as_printed);
  EXPECT_EQ(common->candidates[0].fit, Agreement::kFits);
  EXPECT_FALSE(finding_of(*common));
}

TEST(CommonFactor, NamesACommonFactorThatIsNoConventions) {
  // c = 1.1 in both: too fast for dc, less than rms with svpwm.
  const auto common = common_factor(std::vector{with_speed(10, 21.12), with_speed(20, 10.56)});
  const auto finding = finding_of(*common);
  ASSERT_TRUE(finding);
  EXPECT_NE(finding->sentence.find("the same for all, but no convention's"), std::string::npos)
      << finding->sentence;
}

TEST(CommonFactor, IsAViolationWhereNothingIsFastEnough) {
  // c = 2 and 0.5: above every convention, and below for the other.
  const auto common = common_factor(std::vector{with_speed(10, 38.4), with_speed(20, 4.8)});
  const auto finding = finding_of(*common);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::kViolation) << finding->sentence;
  EXPECT_NE(finding->sentence.find("nor with rounding"), std::string::npos);
}

TEST(SameMotor, LooksOnlyAtOneMotorOnSeveralRatios) {
  Actuator other = with_speed(20, 19.2);
  EXPECT_EQ(same_motor(std::vector{with_speed(10, 19.2), other}).size(), 1u);
  other.motor.torque_constant_Nm_A = 0.126;
  EXPECT_TRUE(same_motor(std::vector{with_speed(10, 19.2), other}).empty());
}

// 19.15...19.25 times 10 against w 20.
TEST(SameMotor, ComparesSpeedsAtTheRotorWithinTheirRounding) {
  EXPECT_TRUE(same_motor(std::vector{with_speed(10, 19.2), with_speed(20, 9.63)}).empty());
  EXPECT_EQ(same_motor(std::vector{with_speed(10, 19.2), with_speed(20, 9.64)}).size(), 1u);
}

}  // namespace
}  // namespace torquewright::actuator::lint
