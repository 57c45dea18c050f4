// SPDX-License-Identifier: Apache-2.0
// Every check, just inside and just outside of what rounding allows. The oracles are the extremes
// of the closed forms over Kt 0.1245...0.1255, R 0.245...0.255, eta 0.945...0.955, worked out by
// hand beside each row.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "actuator/effects/library.hpp"
#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kNone = -1.0;  ///< No bound on that side.

struct Row {
  const char* rule;
  void (*state)(Actuator& document, double number);  ///< And whatever else the check needs.
  double outside_low, inside_low, inside_high, outside_high;
  Severity severity = Severity::kWarning;  ///< At least; a note: exactly.
  /// What part of it a sheet may state with a note: constants 10 % either way, a peak torque 80 %
  /// of that for saturation. The efficiency is known.
  double least = 1.0, greatest = 1.0;
};

template <std::optional<double> Datasheet::*key>
void on_sheet(Actuator& document, double number) {
  *document.datasheet.*key = number;
}

void with_stall_current(Actuator& document, double number) {
  document.datasheet->stall_current_A = 96;
  document.datasheet->stall_torque_Nm = number;
}

void with_stall_and_no_load_current(Actuator& document, double number) {
  document.datasheet->no_load_current_A = 2;
  with_stall_current(document, number);
}

void with_continuous_current(Actuator& document, double number) {
  document.drive.continuous_current_A = 15;
  document.datasheet->rated_torque_Nm = number;
}

void with_peak_torque(Actuator& document, double number) {
  document.datasheet->peak_torque_Nm = 47.5;
  document.datasheet->peak_braking_torque_Nm = number;
}

void beyond_half_stall(Actuator& document, double number) {
  document.drive.peak_current_A = 60;
  document.datasheet->peak_power_W = number;
}

void heat(Actuator& document) {
  document.thermal = Thermal{.winding_to_case_K_W = 1.25,
                             .case_to_ambient_K_W = 2.15,
                             .winding_J_K = 50,
                             .case_J_K = 500,
                             .winding_limit_K = 393.15,
                             .ambient_K = 298.15};
}

void hot_current(Actuator& document, double number) {
  heat(document);
  document.drive.continuous_current_A = number;
}

void hot_torque(Actuator& document, double number) {
  heat(document);
  document.datasheet->rated_torque_Nm = number;
}

Battery battery() {
  Battery pack;
  pack.series_cells = 16;
  pack.cell_open_circuit = {{0.0, 3.0}, {1.0, 4.2}};
  return pack;
}

void with_battery(Actuator& document, double number) {
  document.battery = battery();
  document.drive.bus_voltage_V = number;
}

void charged_to(Actuator& document, double number) {
  with_battery(document, 67.2);
  document.battery->maximum_voltage_V = number;
}

void against_gear(Actuator& document, double number) {
  document.transmission.peak_torque_Nm = 45;
  document.datasheet->peak_torque_Nm = number;
}

void gear(Actuator& document, double number) { document.transmission.peak_torque_Nm = number; }

void efficiencies(Actuator& document, double number) {
  document.transmission.forward_efficiency = 0.9;
  document.transmission.backward_efficiency = number;
}

void with_inductance(Actuator& document, double number) {
  document.motor.inductance_q_H = 0.000125;
  document.datasheet->electrical_time_constant_s = number;
}

void inductance(Actuator& document, double number) { document.motor.inductance_q_H = number; }

void weakened(Actuator& document, double peak_current_A) {
  document.motor.inductance_d_H = 0.000125;
  document.drive.field_weakening = true;
  document.drive.peak_current_A = peak_current_A;
}

void weakened_speed(Actuator& document, double number) {
  weakened(document, 40);
  document.datasheet->no_load_speed_rad_s = number;
}

void magnets(Actuator& document, double number) {
  weakened(document, 40);
  document.motor.demagnetisation_current_A = number;
}

void with_drag(Actuator& document, double number) {
  document.effects.push_back({find_effect("coulomb_friction"), {0.5}, {}, false, ""});
  document.datasheet->no_load_current_A = number;
}

void with_gap(Actuator& document, double number) {
  document.effects.push_back({find_effect("backlash"), {0.004}, {}, false, ""});
  document.datasheet->backlash_rad = number;
}

void back_emf(Actuator& document, double number) {
  document.motor.back_emf_constant_V_s_rad = number;
}

void with_no_load_current(Actuator& document, double number) {
  document.datasheet->no_load_current_A = 4;
  document.datasheet->no_load_speed_rad_s = number;
}

const Row kRows[] = {
    // 0.0035...0.0045
    {"gear-backlash", with_gap, 0.0034, 0.0035, 0.0045, 0.0046, Severity::kNote},
    // 24 / (Kt 10): 19.1235...19.2771
    {"no-load-speed", on_sheet<&Datasheet::no_load_speed_rad_s>, 19.11, 19.12, 19.28, 19.29,
     Severity::kWarning, 0.9, 1.1},
    // (24 - R 3.5...4.5) / (Kt 10): 18.2092...18.5884
    {"no-load-speed", with_no_load_current, 18.19, 18.21, 18.59, 18.61, Severity::kWarning, 0.9,
     1.1},
    // Ke falls by p L_d i to a fifth: 19.1235 up to 99.58
    {"no-load-speed", weakened_speed, 19.11, 19.12, 99, 101, Severity::kWarning, 0.9, 1.1},
    // the no-load speed, 19.1235...19.2771
    {"maximum-speed", on_sheet<&Datasheet::maximum_speed_rad_s>, kNone, 10, 19.28, 19.29,
     Severity::kNote},
    // 0.5 / (10 Kt): 0.39841...0.40161
    {"no-load-current", with_drag, 0.397, 0.398, 0.402, 0.403},
    // Kt
    {"back-emf-constant", back_emf, 0.1244, 0.1246, 0.1255, 0.1256, Severity::kWarning, 0.9, 1.1},
    // 9.5493 / (10 Kt): 7.6090...7.6702
    {"velocity-constant", on_sheet<&Datasheet::velocity_constant_rpm_V>, 7.59, 7.61, 7.67, 7.68,
     Severity::kWarning, 0.9, 1.1},
    // 24 / R: 94.118...97.959
    {"stall-current", on_sheet<&Datasheet::stall_current_A>, 93, 94, 98, 99, Severity::kWarning,
     0.9, 1.1},
    // eta 10 Kt 24 / R: 110.73...117.41
    {"stall-torque", on_sheet<&Datasheet::stall_torque_Nm>, 110, 111, 117, 118, Severity::kWarning,
     0.72, 1.1},
    // eta 10 Kt 95.5...96.5: 112.36...115.66
    {"stall-torque", with_stall_current, 111, 112, 116, 117, Severity::kWarning, 0.72, 1.1},
    // eta 10 Kt (95.5 - 2.5)...96.5: 109.42...115.66, the drag's current taken off or not
    {"stall-torque", with_stall_and_no_load_current, 108, 109, 116, 117, Severity::kWarning, 0.72,
     1.1},
    // eta 10 Kt 40: 47.061...47.941
    {"peak-torque", on_sheet<&Datasheet::peak_torque_Nm>, 46.9, 47.1, 47.9, 48.1,
     Severity::kWarning, 0.72, 1.1},
    // the drive's 40 A, exact as a condition
    {"peak-torque-current", on_sheet<&Datasheet::peak_torque_current_A>, kNone, 10, 40, 40.1,
     Severity::kNote},
    // eta 10 Kt 15: 17.648...17.978
    {"rated-torque", with_continuous_current, 17.5, 17.6, 17.9, 18.1, Severity::kWarning, 0.9, 1.1},
    // 47.45...47.55 over eta and 0.935...0.945: 52.578...53.815
    {"peak-braking-torque", with_peak_torque, 52.5, 52.6, 53.8, 53.9},
    // eta 40 (24 - R 40): 521.64...542.44
    {"peak-power", on_sheet<&Datasheet::peak_power_W>, kNone, 10, 542, 543, Severity::kWarning, 1.0,
     1.1},
    // eta 24^2 / 4R: 533.65...561.31
    {"peak-power", beyond_half_stall, kNone, 10, 561, 562, Severity::kWarning, 1.0, 1.1},
    // 100 J: 0.0445...0.0455
    {"reflected-inertia", on_sheet<&Datasheet::reflected_inertia_kg_m2>, 0.0444, 0.0445, 0.0455,
     0.0456, Severity::kWarning, 0.9, 1.1},
    // root of 95.005 / (3.39 * 0.245 * 1.3705): 9.1359
    {"continuous-current", hot_current, kNone, 5, 9.14, 9.15},
    // 9.55 * 0.1255 * 9.1359: 10.950
    {"rated-torque-heat", hot_torque, kNone, 5, 10.9, 11.1},
    // 16 * 4.15...4.25: 66.4...68
    {"bus-voltage", with_battery, 66.3, 66.4, 68, 68.1},
    {"charge-voltage", charged_to, 66.3, 66.4, 80, kNone},
    // 45.5
    {"gear-limit", against_gear, kNone, 20, 45.5, 45.6},
    // 10 Kt 40: 49.8 at least
    {"motor-against-gear", gear, 49, 49.8, 80, kNone, Severity::kNote},
    // forward 0.85...0.95: 1 - 1.5 (1 - 0.82353) = 0.73529 to 0.95
    {"backward-efficiency", efficiencies, 0.73, 0.74, 0.95, 0.96, Severity::kNote},
    // L 0.0001245...0.0001255 over half of R: 0.97647...1.02449 ms
    {"electrical-time-constant", with_inductance, 0.00097, 0.00098, 0.00102, 0.00103,
     Severity::kWarning, 0.9, 1.1},
    // J R / Kt^2: 6.9222...7.4854 ms
    {"mechanical-time-constant", on_sheet<&Datasheet::mechanical_time_constant_s>, 0.0068, 0.0069,
     0.0075, 0.0076, Severity::kWarning, 0.9, 1.1},
    // half of R times 20 us to 20 ms: 2.45e-6...2.55e-3
    {"winding-inductance", inductance, 0.0000023, 0.0000025, 0.0025, 0.0027, Severity::kNote},
    // 0.05 * 0.125 / (10 * 0.000125) * 0.1245 / 0.125 * 0.125 / 0.1255 / 2, dc amperes: 2.4801
    {"characteristic-current", weakened, 2.48, 2.481, 80, kNone, Severity::kNote},
    {"magnet-limit", magnets, 39, 40, 80, kNone, Severity::kNote},
};

class EachCheck : public testing::TestWithParam<Row> {};

std::optional<Finding> found(const Row& row, double number) {
  Actuator document = sample();
  row.state(document, number);
  EXPECT_TRUE(comparison(document, row.rule)) << row.rule << " does not apply";
  return finding(document, row.rule);
}

TEST_P(EachCheck, AgreesJustInsideTheRounding) {
  const Row& row = GetParam();
  EXPECT_FALSE(found(row, row.inside_low)) << row.rule << " at " << row.inside_low;
  EXPECT_FALSE(found(row, row.inside_high)) << row.rule << " at " << row.inside_high;
}

TEST_P(EachCheck, ObjectsJustOutsideOfIt) {
  const Row& row = GetParam();
  for (const double number : {row.outside_low, row.outside_high}) {
    if (number == kNone) continue;
    const std::optional<Finding> finding = found(row, number);
    ASSERT_TRUE(finding) << row.rule << " at " << number;
    EXPECT_EQ(finding->stated.value, number);
    const bool is_note = finding->severity == Severity::kNote;
    EXPECT_EQ(is_note, row.severity == Severity::kNote || row.greatest > 1.0) << finding->sentence;
    EXPECT_FALSE(finding->expected.pointers.empty());
  }
}

// One percent inside and outside of the tolerance.
TEST_P(EachCheck, AlarmsBeyondItsTolerance) {
  const Row& row = GetParam();
  if (row.greatest == 1.0) return;  // rounding alone
  const auto severity = [&](double number) { return found(row, number).value().severity; };
  EXPECT_EQ(severity(row.inside_high * row.greatest * 0.99), Severity::kNote);
  EXPECT_GT(severity(row.outside_high * row.greatest * 1.01), Severity::kNote);
  if (row.outside_low == kNone) return;
  EXPECT_EQ(severity(row.inside_low * row.least * 1.01), Severity::kNote);
  EXPECT_GT(severity(row.outside_low * row.least * 0.99), Severity::kNote);
}

INSTANTIATE_TEST_SUITE_P(Lint, EachCheck, testing::ValuesIn(kRows), [](const auto& row) {
  std::string name = row.param.rule + std::string("_") + std::to_string(row.index);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// By hand: 24 V / (5 rad/s) = 4.8 Nm/A. Within it nothing is said: the document states no limit.
TEST(TorqueConstantUnit, IsDoubtedWhereNoMotorHasSoMuch) {
  Actuator document = sample();
  document.motor.torque_constant_Nm_A = 4.7;
  EXPECT_FALSE(comparison(document, "torque-constant-unit"));
  document.motor.torque_constant_Nm_A = 4.9;
  const std::optional<Finding> found = finding(document, "torque-constant-unit");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->severity, Severity::kWarning);
  ASSERT_EQ(found->explanations.size(), 1u);
  EXPECT_NEAR(found->explanations[0].expected->value, 0.0049, 1e-15);
  EXPECT_EQ(found->expected.low, 0.0);
  EXPECT_NEAR(found->expected.high, 4.8, 1e-15);
}

// By hand: Kt / sqrt(R) of a dc motor is at most 20 Nm/sqrt(W), with 0.01 ohm 2 Nm/A; the voltage
// would allow 4.8.
TEST(TorqueConstantUnit, IsDoubtedWhereTheWindingHasNoRoomForIt) {
  Actuator document = sample();
  document.motor.resistance_ohm = 0.01;
  document.motor.torque_constant_Nm_A = 1.9;
  EXPECT_FALSE(comparison(document, "torque-constant-unit"));
  document.motor.torque_constant_Nm_A = 2.1;
  EXPECT_NEAR(comparison(document, "torque-constant-unit").value().expected.value, 2.0, 1e-12);
}

// By hand: 100 J and the gears' own, 0.045 (0.0445 to 0.0455) and 0.02 (0.015 to 0.025).
TEST(ReflectedInertia, HoldsThatOfTheGears) {
  Actuator document = sample();
  document.transmission.inertia_kg_m2 = 0.02;
  document.datasheet->reflected_inertia_kg_m2 = 0.06;
  const RoundedInterval expected = comparison(document, "reflected-inertia").value().expected;
  EXPECT_NEAR(expected.value, 0.065, 1e-15);
  EXPECT_NEAR(expected.low, 0.0595, 1e-15);
  EXPECT_NEAR(expected.high, 0.0705, 1e-15);
}

// By hand: a limit of 299 (298.5 to 299.5) K above 298.9 K allows no current at least.
TEST(ContinuousCurrent, MayBeNoneWhereRoundingLeavesNoRoom) {
  Actuator document = sample();
  hot_current(document, 1);
  document.thermal->ambient_K = 298.9;
  document.thermal->winding_limit_K = 299;
  EXPECT_EQ(comparison(document, "continuous-current").value().expected.low, 0.0);
}

// By hand: 0.5 (0.45 to 0.55) forward and equal friction both ways are 0, at most 2 - 1 / 0.55,
// driven back.
TEST(BackwardEfficiency, IsNearlyNoneOfAGearThatLosesHalf) {
  Actuator document = sample();
  document.transmission.forward_efficiency = 0.5;
  const RoundedInterval expected = comparison(document, "backward-efficiency").value().expected;
  EXPECT_EQ(expected.low, 0.0);
  EXPECT_NEAR(expected.high, 2.0 - 1.0 / 0.55, 1e-15);
}

// Nothing is compared with a number that nobody states.
TEST(ContinuousCurrent, IsNotAskedForWhereItIsNotStated) {
  Actuator document = sample();
  heat(document);
  EXPECT_FALSE(comparison(document, "continuous-current"));
  EXPECT_FALSE(comparison(document, "rated-torque-heat"));
}

TEST(Library, HasACaseHereForEveryRule) {
  std::set<std::string> tested{"torque-constant-unit"};
  for (const Row& row : kRows) tested.insert(row.rule);
  for (const Check* check : library()) EXPECT_TRUE(tested.contains(std::string(check->rule)));
}

TEST(Sample, StatesNothingTwice) {
  for (const Comparison& one : examine(sample()).comparisons)
    EXPECT_EQ(one.rule, "backward-efficiency");
}

TEST(Sample, NeedsNoDataSheet) {
  Actuator document = sample();
  document.datasheet.reset();
  EXPECT_TRUE(examine(document).findings.empty());
}

}  // namespace
}  // namespace torquewright::actuator::lint
