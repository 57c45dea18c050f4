// SPDX-License-Identifier: Apache-2.0
// What sides, amperes, tolerances and limits of numbers make of the comparisons. Oracles: closed
// forms by hand over Kt 0.125, R 0.25, 24 V, 10:1.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "actuator/effects/library.hpp"
#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kFewRoundings = 1e-12;

Statement at_joint(const char* pointer, double printed, bool is_joint = true) {
  return {pointer, printed, is_joint, std::nullopt, std::nullopt, {}};
}

Statement in_ampere(const char* pointer, double printed, CurrentConvention ampere) {
  return {pointer, printed, std::nullopt, ampere, std::nullopt, {}};
}

Statement within(const char* pointer, double printed, double tolerance) {
  return {pointer, printed, std::nullopt, std::nullopt, tolerance, {}};
}

/// Behind gears of which nothing is known.
Actuator unknown_gears() {
  Actuator document = sample();
  document.transmission.forward_efficiency = 1.0;
  document.transmission.backward_efficiency = 1.0;
  return document;
}

std::vector<Explanation> explanations_of(const Actuator& document, std::string_view rule) {
  return finding(document, rule).value().explanations;
}

void expect_interval(const RoundedInterval& interval, double low, double high) {
  EXPECT_NEAR(interval.low, low, kFewRoundings * std::abs(low));
  EXPECT_NEAR(interval.high, high, kFewRoundings * std::abs(high));
}

// 1.25 (1.245 to 1.255) Nm/A over 10: at the motor 0.1245 without losses, up to 0.1255 / 0.9.
TEST(StatementsInLint, LeaveOpenWhetherAConstantOfTheJointHoldsTheLosses) {
  Actuator document = unknown_gears();
  document.statements = {at_joint("/motor/torque_constant_Nm_A", 1.25)};
  document.motor.back_emf_constant_V_s_rad = 0.1388;
  const Comparison emf = comparison(document, "back-emf-constant").value();
  expect_interval(emf.expected, 0.1245, 0.1255 / 0.9);
  EXPECT_TRUE(emf.agrees);
  document.transmission.forward_efficiency = 0.5;  // known: no less is lost
  document.transmission.ratio = 20;
  expect_interval(comparison(document, "back-emf-constant")->expected, 1.245 / (20 * 0.55),
                  1.255 / (20 * 0.45));
}

// At the joint it is what was stated there, whatever the gears lose: 1.245 * 40 to 1.255 * 40.
TEST(StatementsInLint, TakeTorquesOfTheJointFromAConstantOfTheJoint) {
  Actuator document = unknown_gears();
  document.statements = {at_joint("/motor/torque_constant_Nm_A", 1.25)};
  document.datasheet->peak_torque_Nm = 50;
  expect_interval(comparison(document, "peak-torque")->expected, 1.245 * 40, 1.255 * 40);
}

// 2.5 V s/rad at the joint are 0.25 at the motor: 24 / 2.5 there.
TEST(StatementsInLint, DivideABackEmfConstantOfTheJointByTheRatio) {
  Actuator document = sample();
  document.motor.back_emf_constant_V_s_rad = 0.25;
  document.statements = {at_joint("/motor/back_emf_constant_V_s_rad", 2.5)};
  document.datasheet->no_load_speed_rad_s = 9.6;
  expect_interval(comparison(document, "no-load-speed")->expected, 24 / 2.55, 24 / 2.45);
}

// Kv of the motor on a sheet of the joint: 9.5493 / 0.125 instead of a tenth of it. What the
// document says, no reading turns.
TEST(StatementsInLint, KeepTheSideOfANumber) {
  Actuator document = sample();
  document.datasheet->velocity_constant_rpm_V = 76.4;
  EXPECT_GT(finding(document, "velocity-constant")->severity, Severity::kNote);
  document.statements = {at_joint("/datasheet/velocity_constant_rpm_V", 76.4, false)};
  EXPECT_TRUE(comparison(document, "velocity-constant")->agrees);
  document.statements = {at_joint("/datasheet/velocity_constant_rpm_V", 76.4, true)};
  for (const Explanation& one : explanations_of(document, "velocity-constant")) {
    EXPECT_EQ(one.sentence.find("data sheet at"), std::string::npos) << one.sentence;
  }
}

// 40 A of amplitude are 40 sqrt(3)/2 dc amperes: 11.875 Nm per 10 of them, eta 0.945 to 0.955.
TEST(StatementsInLint, CountEachCurrentInItsAmpere) {
  const double dc_A = 40 * std::sqrt(3.0) / 2;
  Actuator document = sample();
  document.datasheet->peak_torque_Nm = 41;
  document.datasheet->peak_torque_current_A = 40;
  document.statements = {
      in_ampere("/datasheet/peak_torque_current_A", 40, CurrentConvention::kPeakPhase)};
  const Comparison torque = comparison(document, "peak-torque").value();
  expect_interval(torque.expected, 0.945 * 1.245 * dc_A, 0.955 * 1.255 * dc_A);
  EXPECT_TRUE(torque.agrees);
  // V / R in the ampere in which it is printed: 96 dc are 96 * 2 / sqrt(3) of amplitude.
  document.datasheet->stall_current_A = 110.9;
  document.statements.push_back(
      in_ampere("/datasheet/stall_current_A", 110.9, CurrentConvention::kPeakPhase));
  const Comparison stall = comparison(document, "stall-current").value();
  EXPECT_NEAR(stall.expected.value, 96 * 2 / std::sqrt(3.0), kFewRoundings * 111);
  EXPECT_TRUE(stall.agrees);
}

// What says its ampere is in it, whatever the torque constant counts.
TEST(StatementsInLint, LeaveNoReadingOfAnAmpereThatIsStated) {
  Actuator document = sample();
  document.datasheet->stall_current_A = 60;
  document.statements = {in_ampere("/datasheet/stall_current_A", 60, CurrentConvention::kDc)};
  for (const Explanation& one : explanations_of(document, "stall-current")) {
    EXPECT_EQ(one.sentence.find("current in"), std::string::npos) << one.sentence;
  }
}

// 20 % of a speed that is stated within 20 %: 15.4 to 23; nothing of catalogues beside it.
TEST(StatementsInLint, UseTheToleranceOfTheSource) {
  Actuator document = sample();  // 19.1235 to 19.2771 rad/s
  document.datasheet->no_load_speed_rad_s = 23.5;
  document.statements = {within("/datasheet/no_load_speed_rad_s", 23.5, 0.2)};
  expect_interval(comparison(document, "no-load-speed")->stated, 23.5 * 0.8, 23.5 * 1.2);
  EXPECT_TRUE(comparison(document, "no-load-speed")->agrees);
  document.statements = {within("/datasheet/no_load_speed_rad_s", 20, 0.02)};  // 19.6 to 20.4
  document.datasheet->no_load_speed_rad_s = 20;
  EXPECT_GT(finding(document, "no-load-speed")->severity, Severity::kNote);
  document.statements.clear();  // 19.5 to 20.5: within 10 %
  EXPECT_EQ(finding(document, "no-load-speed")->severity, Severity::kNote);
}

// 24 / (0.25 +- 2 %): with the constant's own tolerance a catalogue's is not added.
TEST(StatementsInLint, UseTheTolerancesOfTheConstants) {
  Actuator document = sample();
  document.datasheet->stall_current_A = 101;
  EXPECT_EQ(finding(document, "stall-current")->severity, Severity::kNote);
  document.statements = {within("/motor/resistance_ohm", 0.25, 0.02)};
  expect_interval(comparison(document, "stall-current")->expected, 24 / 0.255, 24 / 0.245);
  EXPECT_GT(finding(document, "stall-current")->severity, Severity::kNote);
  document.statements = {within("/motor/resistance_ohm", 0.25, 0.06)};
  EXPECT_FALSE(finding(document, "stall-current"));
}

// V / R is 96 A, the drive gives 40: no contradiction where the sheet says that it is the limit,
// and none of the torque at it; a limit beyond V / R is one.
TEST(StatementsInLint, KnowAStallCurrentThatIsTheDrivesLimit) {
  Actuator document = sample();
  document.datasheet->stall_current_A = 40;
  document.datasheet->stall_torque_Nm = 47.5;
  EXPECT_TRUE(has_contradiction(examine_all(std::vector{document})));
  document.datasheet->stall_limit = StallLimit::kDrive;
  EXPECT_FALSE(has_contradiction(examine_all(std::vector{document})));
  document.datasheet->stall_current_A.reset();  // then the drive's own 40 A
  EXPECT_TRUE(comparison(document, "stall-torque")->agrees);
  document.datasheet->stall_torque_Nm.reset();
  document.datasheet->stall_current_A = 120;
  EXPECT_GT(finding(document, "stall-current")->severity, Severity::kNote);
  document.datasheet->stall_current_A = 40;
  document.datasheet->stall_limit = StallLimit::kWinding;
  for (const Explanation& one : explanations_of(document, "stall-current")) {
    EXPECT_NE(one.sentence, "stall at the drive's peak current");
  }
}

// 24 V make 19.2 rad/s: bearings may stand less, which is no matter, or more, which is a note.
TEST(StatementsInLint, TakeAMaximumSpeedForNoNoLoadSpeed) {
  Actuator document = sample();
  for (const auto& [speed_rad_s, is_note] : {std::pair{15.0, false}, {21.0, false}, {80.0, true}}) {
    document.datasheet->maximum_speed_rad_s = speed_rad_s;
    const Report report = examine_all(std::vector{document});
    EXPECT_FALSE(has_contradiction(report)) << speed_rad_s;
    const auto found = finding(document, "maximum-speed");
    const bool is_doubted = found && found->sentence.ends_with("possible, but check it.");
    EXPECT_EQ(is_doubted, is_note) << speed_rad_s;
  }
}

Statement bounded(const char* pointer, double printed, Bound bound) {
  Statement statement{pointer, printed, std::nullopt, std::nullopt, std::nullopt, {}};
  statement.bound = bound;
  return statement;
}

// eta N Kt I is 0.945 * 10 * 0.1245 * 95.5 to 0.955 * 10 * 0.1255 * 96.5, 112.36 to 115.66 Nm; a
// catalogue may state 72 % (constants and saturation) to 110 % of that, 80.9 to 127.22 Nm. A bound
// is exact, and is contradicted from one side alone.
TEST(StatementsInLint, HoldABoundFromOneSide) {
  struct Case {
    double torque_Nm;
    Bound bound;
    bool is_contradicted;
  };
  for (const Case& each : {Case{20, Bound::kAtLeast, false},
                           {127.2, Bound::kAtLeast, false},
                           {127.3, Bound::kAtLeast, true},
                           {900, Bound::kAtLeast, true},
                           {900, Bound::kAtMost, false},
                           {81, Bound::kAtMost, false},
                           {80.8, Bound::kAtMost, true},
                           {20, Bound::kAtMost, true}}) {
    Actuator document = sample();
    document.datasheet->stall_current_A = 96;
    document.datasheet->stall_torque_Nm = each.torque_Nm;
    document.statements = {bounded("/datasheet/stall_torque_Nm", each.torque_Nm, each.bound)};
    const auto found = finding(document, "stall-torque");
    const bool is_contradicted = found && found->severity != Severity::kNote;
    EXPECT_EQ(is_contradicted, each.is_contradicted) << each.torque_Nm;
    const RoundedInterval stated = comparison(document, "stall-torque")->stated;
    const bool is_least = each.bound == Bound::kAtLeast;
    EXPECT_EQ(stated.low, is_least ? each.torque_Nm : 0.0);
    EXPECT_EQ(stated.high, is_least ? kUnlimited : each.torque_Nm);
  }
}

// R at most 0.25 lets at least 24 / 0.25 A through: what follows from a bound is one.
TEST(StatementsInLint, DeriveABoundFromABound) {
  Actuator document = sample();
  document.statements = {bounded("/motor/resistance_ohm", 0.25, Bound::kAtMost)};
  document.datasheet->stall_current_A = 500;
  const Comparison comparison_of_stall = comparison(document, "stall-current").value();
  EXPECT_EQ(with_interval(comparison_of_stall.expected, "A"), "at least 96 A");
  EXPECT_TRUE(comparison_of_stall.agrees);
  document.datasheet->stall_current_A = 60;
  EXPECT_GT(finding(document, "stall-current")->severity, Severity::kNote);
}

// A gap of 0.004 rad is 0.0035 to 0.0045, 12.03 to 15.47 arcmin.
TEST(StatementsInLint, HoldTheDeclaredGapAgainstTheSheetsBacklash) {
  Actuator document = sample();
  document.effects.push_back({find_effect("backlash"), {0.004}, {}, false, ""});
  constexpr double kArcmin_rad = std::numbers::pi / 180.0 / 60.0;
  for (const auto& [arcmin, agrees] :
       {std::pair{10.0, false}, {12.0, false}, {12.1, true}, {15.5, true}}) {
    document.datasheet->backlash_rad = arcmin * kArcmin_rad;
    document.statements = {
        bounded("/datasheet/backlash_rad", arcmin * kArcmin_rad, Bound::kAtMost)};
    EXPECT_EQ(comparison(document, "gear-backlash")->agrees, agrees) << arcmin;
    EXPECT_FALSE(has_contradiction(examine_all(std::vector{document}))) << arcmin;
  }
}

}  // namespace
}  // namespace torquewright::actuator::lint
