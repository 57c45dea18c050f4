// SPDX-License-Identifier: Apache-2.0
// Invented sheets by closed form: a motor of flux linkage times pole pairs k, whose every number
// follows from k; then one of them is read, or printed, otherwise.
#include "actuator/lint/joint_explanation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kLinkage = 0.08;  // V s/rad of one phase, amplitude
constexpr double kOhm = 0.3;       // between lines
constexpr double kVolt = 48.0;
constexpr double kInertia_kg_m2 = 1.2345e-4;
constexpr double kRpmPerRad_s = 30.0 / 3.14159265358979323846;

/// dc ampere: Kt = Ke = sqrt(3) k; stall at V / R; J R / Kt^2.
Actuator invented() {
  const double constant = std::sqrt(3.0) * kLinkage;
  Actuator document;
  document.name = "invented";
  document.motor.torque_constant_Nm_A = constant;
  document.motor.back_emf_constant_V_s_rad = constant;
  document.motor.resistance_ohm = kOhm;
  document.motor.resistance_convention = ResistanceConvention::kLineToLine;
  document.motor.rotor_inertia_kg_m2 = kInertia_kg_m2;
  document.drive.bus_voltage_V = kVolt;
  document.drive.peak_current_A = 160.0;
  document.datasheet = Datasheet{};
  Datasheet& sheet = *document.datasheet;
  sheet.no_load_speed_rad_s = kVolt / constant;
  sheet.stall_current_A = kVolt / kOhm;
  sheet.stall_torque_Nm = constant * kVolt / kOhm;
  sheet.velocity_constant_rpm_V = kRpmPerRad_s / constant;
  sheet.mechanical_time_constant_s = kInertia_kg_m2 * kOhm / (constant * constant);
  return document;
}

Finding the_contradiction(const Actuator& document) {
  std::vector<Finding> found;
  for (const Finding& one : examine(document).findings) {
    if (one.severity != Severity::kNote) found.push_back(one);
  }
  EXPECT_EQ(found.size(), 1u);
  return found.empty() ? Finding() : found.front();
}

using Words = std::vector<std::string>;

TEST(JointExplanation, IsAskedOfNoSoundSheet) {
  EXPECT_FALSE(has_contradiction(examine_all(std::vector{invented()})));
}

// Ohms between lines written as those of a phase: stall current and time constant are off by 2, and
// one reading takes both.
TEST(JointExplanation, FindsTheOneReadingBehindManyContradictions) {
  Actuator document = invented();
  document.motor.resistance_convention = ResistanceConvention::kPhase;
  const Finding finding = the_contradiction(document);
  EXPECT_EQ(finding.rule, "whole-sheet");
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_EQ(finding.explained_by, Words{"resistance between two lines"});
}

// Ke as phase peak under dc (k instead of sqrt(3) k), and the sheet's Kv per line-to-line rms volt.
TEST(JointExplanation, TakesTwoReadingsWhereOneWillNotDo) {
  Actuator document = invented();
  document.motor.back_emf_constant_V_s_rad = kLinkage;
  document.datasheet->velocity_constant_rpm_V = kRpmPerRad_s / (std::sqrt(1.5) * kLinkage);
  const Finding finding = the_contradiction(document);
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_EQ(finding.explained_by, (Words{"back-EMF constant as phase peak",
                                         "velocity constant per volt line-to-line rms"}));
}

// A torque constant per rms ampere under dc, 3/sqrt(2) k instead of sqrt(3) k, and 1.6 % off as
// constants of catalogues are: one reading all the same, since no other comes as near.
TEST(JointExplanation, LeavesAReadingWhatIsLessThanTheDistanceOfTwo) {
  Actuator document = invented();
  Datasheet& sheet = *document.datasheet;
  sheet.stall_current_A = sheet.stall_torque_Nm = sheet.mechanical_time_constant_s = std::nullopt;
  document.motor.torque_constant_Nm_A = 1.016 * 3.0 / std::sqrt(2.0) * kLinkage;
  const Finding finding = the_contradiction(document);
  EXPECT_EQ(finding.rule, "whole-sheet");
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_EQ(finding.explained_by, Words{"torque constant per rms ampere, svpwm modulation"});
  document.motor.torque_constant_Nm_A *= 1.03 / 1.016;
  EXPECT_EQ(the_contradiction(document).severity, Severity::kViolation);
}

// Stall current and torque measured at 24 V where the rest of the sheet holds 48; a speed at 60 V.
// A third of a voltage that nobody supplies explains nothing.
TEST(JointExplanation, KnowsTheVoltageAtWhichANumberWasStated) {
  Actuator document = invented();
  *document.datasheet->stall_current_A /= 2.0;
  *document.datasheet->stall_torque_Nm /= 2.0;
  EXPECT_EQ(the_contradiction(document).explained_by, Words{"stall-current: stated at 24 V"});
  document = invented();
  *document.datasheet->no_load_speed_rad_s *= 60.0 / 48.0;
  EXPECT_EQ(the_contradiction(document).explained_by, Words{"no-load-speed: stated at 60 V"});
  document.drive.bus_voltage_V = 64.0;
  document.datasheet->voltage_V = kVolt;
  *document.datasheet->no_load_speed_rad_s *= 64.0 / 60.0;
  EXPECT_EQ(the_contradiction(document).explained_by, Words{"no-load-speed: stated at 64 V"});
  *document.datasheet->no_load_speed_rad_s *= 66.0 / 64.0;
  EXPECT_EQ(the_contradiction(document).severity, Severity::kViolation);
}

// Each numeral of the sheet alone, three times too large: no reading has a factor of 3 but losses
// and loads, which only take away.
TEST(JointExplanation, NamesTheNumeralThatSpoilsTheSheet) {
  struct Spoiled {
    const char* pointer;
    std::optional<double> Datasheet::*key;
  };
  for (const Spoiled& spoiled :
       {Spoiled{"/datasheet/no_load_speed_rad_s", &Datasheet::no_load_speed_rad_s},
        {"/datasheet/stall_torque_Nm", &Datasheet::stall_torque_Nm},
        {"/datasheet/velocity_constant_rpm_V", &Datasheet::velocity_constant_rpm_V}}) {
    Actuator document = invented();
    *(*document.datasheet.*spoiled.key) *= 3.0;
    const Finding finding = the_contradiction(document);
    EXPECT_EQ(finding.severity, Severity::kViolation) << spoiled.pointer;
    EXPECT_EQ(finding.culprits, std::vector<Words>{{spoiled.pointer}});
    EXPECT_NE(finding.sentence.find(spoiled.pointer), std::string::npos) << finding.sentence;
  }
}

// Rotor inertia and time constant stand in one comparison only: one of the two.
TEST(JointExplanation, NamesBothWhereNothingElseTells) {
  Actuator document = invented();
  *document.datasheet->mechanical_time_constant_s *= 3.0;
  EXPECT_EQ(the_contradiction(document).culprits,
            (std::vector<Words>{{"/datasheet/mechanical_time_constant_s"},
                                {"/motor/rotor_inertia_kg_m2"}}));
}

// Two numerals that nothing confirms rather than the constant that they share, which much does.
TEST(JointExplanation, NamesTwoNumeralsBeforeOneThatAgreesElsewhere) {
  Actuator document = invented();
  *document.datasheet->stall_torque_Nm *= 3.0;
  *document.datasheet->velocity_constant_rpm_V *= 3.0;
  EXPECT_EQ(
      the_contradiction(document).culprits,
      (std::vector<Words>{{"/datasheet/velocity_constant_rpm_V", "/datasheet/stall_torque_Nm"}}));
}

// The torque constant three times too large spoils four comparisons; the back-EMF constant, which
// the speed confirms, is no suspect.
TEST(JointExplanation, NamesAConstantThatSpoilsSeveralComparisons) {
  Actuator document = invented();
  document.motor.torque_constant_Nm_A *= 3.0;
  const Finding finding = the_contradiction(document);
  EXPECT_EQ(finding.rule, "whole-sheet");
  EXPECT_EQ(finding.severity, Severity::kViolation);
  EXPECT_EQ(finding.culprits, std::vector<Words>{{"/motor/torque_constant_Nm_A"}});
}

// A torque constant a thousand times too large is doubted by itself, beside what it contradicts.
TEST(JointExplanation, LeavesOutTheDoubtOfAUnit) {
  Actuator document = invented();
  document.motor.torque_constant_Nm_A *= 1000.0;
  const Examination examined = examine(document);
  ASSERT_TRUE(finding(examined, "torque-constant-unit"));
  EXPECT_EQ(finding(examined, "torque-constant-unit")->severity, Severity::kWarning);
  ASSERT_TRUE(finding(examined, "whole-sheet"));
  EXPECT_EQ(finding(examined, "whole-sheet")->culprits,
            std::vector<Words>{{"/motor/torque_constant_Nm_A"}});
}

// A reading that fits one pair and breaks another explains no sheet: with Kt per rms ampere the
// velocity constant alone would be sqrt(3/2) of what it is, but so would the speed.
TEST(JointExplanation, LeavesOutReadingsThatBreakWhatHolds) {
  Actuator document = invented();
  document.motor.back_emf_constant_V_s_rad.reset();
  *document.datasheet->velocity_constant_rpm_V *= std::sqrt(1.5);
  const Finding finding = the_contradiction(document);
  ASSERT_EQ(finding.rule, "velocity-constant");
  EXPECT_EQ(
      explanation(finding, "torque constant per rms ampere, back-EMF as line-to-line peak").breaks,
      "no-load-speed");
  for (const std::string& reading : finding.explained_by) {
    EXPECT_EQ(reading.find("torque constant per rms"), std::string::npos) << reading;
  }
}

}  // namespace
}  // namespace torquewright::actuator::lint
