// SPDX-License-Identifier: Apache-2.0
// Table II of the paper on the hopper with the optimised gearbox: D151 and D110A.
// Oracle: the candidate table of the convention factors (0.866 = sqrt(3)/2, 0.75, 0.955 = 3/pi, and
// those times sqrt(2)) on c V / (Kt N), and its rounding intervals, computed apart from this
// program.
#include <gtest/gtest.h>

#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kPrinted = 0.005;  ///< Half a unit of the oracle's last decimal.
constexpr double kPrintedFactor = 5e-4;

class TableII : public testing::Test {
 protected:
  const Actuator knee_ = from_specs("d151_knee.json");
  const Actuator ankle_ = from_specs("d110a_ankle.json");
};

TEST_F(TableII, IsWhatTheSpecificationsState) {
  EXPECT_EQ(*knee_.datasheet->peak_torque_Nm, 320);
  EXPECT_EQ(*knee_.datasheet->no_load_speed_rad_s, 10);
  EXPECT_EQ(knee_.motor.torque_constant_Nm_A, 0.32);
  EXPECT_EQ(knee_.motor.rotor_inertia_kg_m2, 0.000922);
  EXPECT_EQ(knee_.transmission.ratio, 20);
  EXPECT_EQ(*ankle_.datasheet->peak_torque_Nm, 176);
  EXPECT_EQ(*ankle_.datasheet->no_load_speed_rad_s, 20);
  EXPECT_EQ(ankle_.motor.torque_constant_Nm_A, 0.44);
  EXPECT_EQ(ankle_.motor.rotor_inertia_kg_m2, 0.0002);
  EXPECT_EQ(ankle_.transmission.ratio, 8);
  for (const Actuator* one : {&knee_, &ankle_}) {
    EXPECT_EQ(*one->datasheet->voltage_V, 67.2);
    EXPECT_EQ(*one->datasheet->peak_torque_current_A, 50);
  }
}

TEST_F(TableII, HasTorquesThatAreComputedWithoutLoss) {
  for (const Actuator* one : {&knee_, &ankle_}) {
    const auto torque = comparison(*one, "peak-torque");
    ASSERT_TRUE(torque);
    EXPECT_NEAR(torque->expected.value, torque->stated.value, 1e-12 * torque->stated.value);
  }
}

TEST_F(TableII, AgreesForTheKneeAndNamesTheRivalConvention) {
  const Examination knee = examine(knee_);
  const auto note = finding(knee, "no-load-speed");
  ASSERT_TRUE(note);
  EXPECT_EQ(knee.findings.size(), 1u);
  EXPECT_EQ(note->severity, Severity::kNote);
  EXPECT_NEAR(note->expected.value, 10.50, kPrinted);
  const auto six_step = explanation(*note, "torque constant per peak ampere, six_step modulation");
  EXPECT_EQ(six_step.fit, Agreement::kFits);
  EXPECT_NEAR(six_step.expected->value, 10.03, kPrinted);
  EXPECT_EQ(note->assumed, std::vector<std::string>{"/motor/torque_constant_convention"});
}

// By 1 % beyond rounding: catalogues are as far apart, but the convention is assumed.
TEST_F(TableII, IsTolerableForTheAnkle) {
  const auto speed = finding(ankle_, "no-load-speed");
  ASSERT_TRUE(speed);
  EXPECT_EQ(speed->severity, Severity::kNote);
  EXPECT_EQ(speed->stated.value, 20);
  EXPECT_NEAR(speed->expected.value, 19.09, kPrinted);
  EXPECT_NEAR(limit(*speed), 67.2 / (0.435 * 8), 1e-12 * 20);
  EXPECT_NE(speed->sentence.find("20 (19.5 to 20.5) rad/s"), std::string::npos) << speed->sentence;
  EXPECT_NE(speed->sentence.find("19.09 (18.88 to 19.31) rad/s"), std::string::npos);

  const auto sine = explanation(*speed, "torque constant per rms ampere, sine modulation");
  EXPECT_EQ(sine.fit, Agreement::kFits);
  EXPECT_NEAR(sine.expected->value, 20.25, kPrinted);
  const auto svpwm = explanation(*speed, "torque constant per rms ampere, svpwm modulation");
  EXPECT_EQ(svpwm.fit, Agreement::kAdmits);
  const auto peak = explanation(*speed, "torque constant per peak ampere, svpwm modulation");
  EXPECT_EQ(peak.fit, Agreement::kExcludes);
  EXPECT_EQ(explanation(*speed, "a round number: 20 printed for 15 to 25").fit, Agreement::kFits);
}

struct Candidate {
  const char* sentence;
  double factor, knee_rad_s, ankle_rad_s;
  Agreement fit;
};

TEST_F(TableII, HasTheCandidatesOfBoth) {
  const Candidate kCandidates[] = {
      {"Kt = Ke (dc ampere)", 1, 10.50, 19.09, Agreement::kExcludes},
      {"Nm per peak ampere, svpwm", 0.866, 9.09, 16.53, Agreement::kExcludes},
      {"Nm per peak ampere, sine", 0.75, 7.88, 14.32, Agreement::kExcludes},
      {"Nm per peak ampere, six_step", 0.955, 10.03, 18.23, Agreement::kExcludes},
      {"Nm per rms ampere, svpwm", 1.225, 12.86, 23.38, Agreement::kAdmits},
      {"Nm per rms ampere, sine", 1.061, 11.14, 20.25, Agreement::kAdmits},
      {"Nm per rms ampere, six_step", 1.350, 14.18, 25.78, Agreement::kAdmits},
  };
  const auto common = common_factor(std::vector{knee_, ankle_});
  ASSERT_TRUE(common);
  ASSERT_EQ(common->candidates.size(), std::size(kCandidates));
  for (std::size_t i = 0; i < std::size(kCandidates); ++i) {
    const FactorCandidate& candidate = common->candidates[i];
    EXPECT_EQ(candidate.sentence, kCandidates[i].sentence);
    EXPECT_NEAR(candidate.factor, kCandidates[i].factor, kPrintedFactor);
    EXPECT_NEAR(candidate.speeds_rad_s[0].value, kCandidates[i].knee_rad_s, kPrinted + 1e-9);
    EXPECT_NEAR(candidate.speeds_rad_s[1].value, kCandidates[i].ankle_rad_s, kPrinted);
    EXPECT_EQ(candidate.fit, kCandidates[i].fit) << candidate.sentence;
  }
}

TEST_F(TableII, HasNoSingleFactorForBoth) {
  const Report report = examine_all(std::vector{knee_, ankle_});
  ASSERT_TRUE(report.common_factor);
  const std::vector<RequiredFactor>& required = report.common_factor->required;
  EXPECT_NEAR(required[0].factor.value, 0.952, kPrintedFactor);
  EXPECT_NEAR(required[0].factor.low, 0.891, kPrintedFactor);
  EXPECT_NEAR(required[0].factor.high, 1.016, kPrintedFactor);
  EXPECT_NEAR(required[1].factor.value, 1.048, kPrintedFactor);
  EXPECT_NEAR(required[1].factor.low, 1.010, kPrintedFactor);
  EXPECT_NEAR(required[1].factor.high, 1.086, kPrintedFactor);
  EXPECT_NEAR(report.common_factor->low, 1.010, kPrintedFactor);
  EXPECT_NEAR(report.common_factor->high, 1.016, kPrintedFactor);
  // Of two motors within what catalogues leave open, but the convention is assumed: a note.
  EXPECT_FALSE(has_contradiction(report));
  const Finding& both = report.findings.back();
  EXPECT_EQ(both.rule, "common-convention");
  EXPECT_EQ(both.severity, Severity::kNote);
  EXPECT_NE(both.sentence.find("no single factor fits both as printed"), std::string::npos);
  EXPECT_EQ(explanation(both, "Nm per rms ampere, sine: then 50 A are 70.7 A of amplitude").fit,
            Agreement::kAdmits);
  for (const Explanation& one : both.explanations) {  // both documents exclude it
    EXPECT_EQ(one.sentence.find("weakening"), std::string::npos) << one.sentence;
  }
}

}  // namespace
}  // namespace torquewright::actuator::lint
