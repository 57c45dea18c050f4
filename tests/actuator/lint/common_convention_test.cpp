// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/common_convention.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  // c = 1.55 in both: beyond rms with six steps, 1.35, and its tolerance of 10 %.
  const auto common = common_factor(std::vector{with_speed(10, 29.76), with_speed(20, 14.88)});
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

// Two motors of a catalogue (tests named by hand: 0.0378 Nm/A at 24 V make 634.9 rad/s, 0.04243
// make 565.6): c = 1.006 and 1.000, each beyond the other's rounding and far within the 10 % by
// which the rule for one speed lets catalogues differ. Beyond that, just outside 110 %, it is a
// finding.
TEST(CommonFactor, LeavesToEachMotorWhatTheRuleForOneSpeedLeaves) {
  const auto catalogue = [](double constant_Nm_A, double speed_rad_s) {
    Actuator document = with_speed(1, speed_rad_s);
    document.motor.torque_constant_Nm_A = constant_Nm_A;
    document.assumed.clear();
    return document;
  };
  const auto finding = [&](double other_rad_s) {
    const auto common =
        common_factor(std::vector{catalogue(0.0378, 638.8), catalogue(0.04243, other_rad_s)});
    EXPECT_NE(common.value().candidates[0].fit, Agreement::kFits);  // not within rounding
    return finding_of(*common);
  };
  EXPECT_FALSE(finding(565.5));
  EXPECT_FALSE(finding(1.099 * 565.6));
  EXPECT_EQ(finding(2.0 * 565.6).value().severity, Severity::kViolation);
}

// The same where nobody says which ampere is meant: worth a note, no alarm.
TEST(CommonFactor, NotesAToleratedConventionThatIsAssumed) {
  Actuator one = with_speed(10, 19.2), other = with_speed(20, 10.3);
  one.assumed = {"/motor/torque_constant_convention"};
  const Finding finding = finding_of(common_factor(std::vector{one, other}).value()).value();
  EXPECT_EQ(finding.severity, Severity::kNote);
  EXPECT_NE(finding.sentence.find("within what catalogues leave open Kt = Ke (dc ampere)"),
            std::string::npos)
      << finding.sentence;
}

// By hand: 0.6 A through 4 ohm are a tenth of 24 V, so that a speed 15 % below V / Kt lies within a
// tenth of what the voltage that is left makes.
TEST(CommonFactor, LeavesTheNoLoadCurrentItsShare) {
  const auto is_silent = [](std::optional<double> no_load_A) {
    std::vector<Actuator> both{with_speed(10, 19.2), with_speed(20, 0.85 * 9.6)};
    for (Actuator& each : both) {
      each.assumed.clear();
      each.motor.resistance_ohm = 4;
      each.datasheet->no_load_current_A = no_load_A;
    }
    return !finding_of(common_factor(both).value());
  };
  EXPECT_TRUE(is_silent(0.6));
}

Actuator weakened(Actuator document, double inductance_d_H) {
  document.drive.field_weakening = true;
  document.motor.inductance_d_H = inductance_d_H;
  return document;
}

// By hand: the second needs c = 1.2 (1.195 at least). Ke / (Ke - p L_d i) in amplitudes, 0.125 /
// sqrt(3) and 80 / sqrt(3) A: 5 for 125 uH, 1.068 for 10 uH. Without field weakening: 1.
TEST(CommonFactor, OffersFieldWeakeningAsFarAsItGoes) {
  const auto offers = [](const Actuator& ankle) {
    const auto common = common_factor(std::vector{with_speed(10, 19.2), ankle});
    const std::vector<Explanation> all = finding_of(common.value()).value().explanations;
    return std::any_of(all.begin(), all.end(), [](const Explanation& one) {
      return one.sentence.find("weakening") != std::string::npos;
    });
  };
  EXPECT_FALSE(offers(with_speed(20, 11.52)));
  EXPECT_FALSE(offers(weakened(with_speed(20, 11.52), 0.00001)));
  EXPECT_TRUE(offers(weakened(with_speed(20, 11.52), 0.000125)));
}

// By hand: the second needs c = 1.2, field weakening by 20 %. Per rms ampere and svpwm, c = 1.22,
// nothing is too fast, but the drive would give 40 sqrt(2) = 56.6 A of amplitude.
TEST(CommonFactor, TellsWhatEachWayOutAsksFor) {
  const auto common =
      common_factor(std::vector{with_speed(10, 19.2), weakened(with_speed(20, 11.52), 0.000125)});
  const Finding finding = finding_of(common.value()).value();
  EXPECT_EQ(finding.rule, "common-convention");
  EXPECT_EQ(finding.actuator, "sample, sample");
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_NEAR(finding.expected.value, 1.0, 1e-12);
  EXPECT_NEAR(finding.stated.value, 1.2, 1e-12);
  EXPECT_NE(finding.sentence.find("no single factor fits both as printed, nor with rounding"),
            std::string::npos)
      << finding.sentence;
  EXPECT_EQ(
      explanation(finding, "Kt = Ke (dc ampere), and field weakening only on sample by 20.0 %").fit,
      Agreement::kFits);
  EXPECT_EQ(explanation(finding, "Nm per rms ampere, svpwm: then 40 A are 56.6 A of amplitude").fit,
            Agreement::kAdmits);
}

// By hand: V / (Kt N) = 19.2 rad/s times c of the convention: 1, and for rms and svpwm sqrt(1.5).
TEST(CommonFactor, HoldsEachConventionsSpeeds) {
  const auto common = common_factor(std::vector{with_speed(10, 19.2), with_speed(20, 9.6)}).value();
  for (const FactorCandidate& candidate : common.candidates) {
    ASSERT_EQ(candidate.speeds_rad_s.size(), 2u);
    EXPECT_NEAR(candidate.speeds_rad_s[0].value, 19.2 * candidate.factor, 1e-12 * 20);
    EXPECT_NEAR(candidate.speeds_rad_s[1].value, 9.6 * candidate.factor, 1e-12 * 20);
  }
  EXPECT_NEAR(common.candidates[0].factor, 1.0, 1e-12);
  EXPECT_NEAR(common.candidates[4].factor, std::sqrt(1.5), 1e-12);
}

Actuator named(const char* name, double ratio) {
  Actuator document = sample();
  document.name = name;
  document.transmission.ratio = ratio;
  return document;
}

// By hand: 40 Nm / (0.95 * 10) = 4.2105 Nm and 120 / (0.95 * 20) = 6.3158 Nm at the rotor.
TEST(SameMotor, ComparesTorquesBeforeTheGears) {
  Actuator one = named("one", 10);
  Actuator other = named("other", 20);
  one.datasheet->peak_torque_Nm = 40;
  other.datasheet->peak_torque_Nm = 120;
  const std::vector<Finding> findings = same_motor(std::vector{one, other});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].rule, "same-motor-torque");
  EXPECT_EQ(findings[0].actuator, "one, other");
  EXPECT_EQ(findings[0].unit, "Nm");
  EXPECT_NEAR(findings[0].expected.value, 40 / 9.5, 1e-12);
  EXPECT_NEAR(findings[0].stated.value, 120 / 19.0, 1e-12);
  other.datasheet->peak_torque_Nm = 80;
  EXPECT_TRUE(same_motor(std::vector{one, other}).empty());
}

// By hand: N^2 J + G is 0.06 and 0.18 for J = 0.0004 and G = 0.02; 0.06 and 0.31 want G < 0.
TEST(SameMotor, SplitsInertiasIntoRotorAndGears) {
  Actuator one = named("one", 10);
  Actuator other = named("other", 20);
  one.datasheet->reflected_inertia_kg_m2 = 0.06;
  other.datasheet->reflected_inertia_kg_m2 = 0.18;
  const std::vector<Finding> findings = same_motor(std::vector{one, other});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].rule, "same-motor-inertia");
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_NEAR(findings[0].expected.value, 0.0006, 1e-15);
  EXPECT_EQ(
      explanation(findings[0], "a rotor of 0.0004 kg m^2 and gears of 0.02 kg m^2 at each joint")
          .fit,
      Agreement::kFits);
  other.datasheet->reflected_inertia_kg_m2 = 0.31;
  EXPECT_EQ(same_motor(std::vector{one, other}).at(0).severity, Severity::kViolation);
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
