// SPDX-License-Identifier: Apache-2.0
// Numbers that say their side, ampere and tolerance. Oracles: the conversions by hand, and the same
// document in plain numbers.
#include "actuator/motor/statement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "actuator/check/check.hpp"
#include "actuator/mor/mor_table.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "io/documents/document.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

json plain() {
  return json::parse(R"({"kind": "actuator", "version": 1, "name": "knee",
    "motor": {"torque_constant_Nm_A": 0.25, "torque_constant_convention": "rms_phase",
      "back_emf_constant_V_s_rad": 0.125, "resistance_ohm": 0.3, "resistance_convention": "phase",
      "inductance_d_H": 1e-4, "inductance_q_H": 1e-4, "pole_pairs": 10,
      "demagnetisation_current_A": 60},
    "drive": {"bus_voltage_V": 48, "peak_current_A": 30, "continuous_current_A": 10,
      "modulation": "svpwm", "field_weakening": true},
    "gearbox": {"ratio": -8, "forward_efficiency": 0.8, "backward_efficiency": 0.75},
    "datasheet": {"side": "motor", "rated_torque_Nm": 2}})");
}

/// The same, as another data sheet would say it: 0.25 * 8 * 0.8 and 0.125 * 8 at the joint, rms
/// amperes as amplitudes and as amperes of the equivalent winding (sqrt(3/2) of them).
json restated() {
  json document = plain();
  document["motor"]["torque_constant_Nm_A"] = {{"value", 1.6}, {"side", "joint"}};
  document["motor"]["back_emf_constant_V_s_rad"] = {{"value", 1.0}, {"side", "joint"}};
  document["motor"]["resistance_ohm"] = {{"value", 0.3}, {"tolerance", 0.1}};
  document["motor"]["demagnetisation_current_A"] = {{"value", 60}, {"ampere", "rms"}};
  document["drive"]["peak_current_A"] = {{"value", 30 * std::sqrt(2.0)}, {"ampere", "peak"}};
  document["drive"]["continuous_current_A"] = {{"value", 10 * std::sqrt(1.5)}, {"ampere", "dc"}};
  document["datasheet"]["side"] = "joint";
  document["datasheet"]["rated_torque_Nm"] = {{"value", 2}, {"side", "motor"}};
  return document;
}

ReadActuator read(const json& document) {
  return read_actuator(io::check_document(document, "actuator", "knee.json", ""));
}

std::vector<io::Fault> faults_of(const json& document) {
  try {
    read(document);
  } catch (const io::SpecError& error) {
    return error.faults();
  }
  return {};
}

void expect_same(double one, double other) {
  EXPECT_NEAR(one, other, 1e-12 * std::max(1.0, std::abs(one)));
}

TEST(Statements, AreCarriedToTheMotorAndToItsAmpere) {
  const Actuator actuator = read(restated()).actuator;
  expect_same(actuator.motor.torque_constant_Nm_A, 0.25);
  expect_same(*actuator.motor.back_emf_constant_V_s_rad, 0.125);
  expect_same(actuator.motor.resistance_ohm, 0.3);
  expect_same(actuator.motor.demagnetisation_current_A, 60);
  expect_same(actuator.drive.peak_current_A, 30);
  expect_same(*actuator.drive.continuous_current_A, 10);
  EXPECT_FALSE(is_at_joint(actuator, "/datasheet/rated_torque_Nm"));
  EXPECT_TRUE(is_at_joint(actuator, "/datasheet/stall_torque_Nm"));
  EXPECT_EQ(find_statement(actuator, "/motor/resistance_ohm")->tolerance, 0.1);
  EXPECT_EQ(find_statement(actuator, "/drive/bus_voltage_V"), nullptr);
}

TEST(Statements, GiveTheSameRegion) {
  const Actuator one = read(plain()).actuator, other = read(restated()).actuator;
  for (const Rating rating : {Rating::kPeak, Rating::kContinuous}) {
    OperatingConditions conditions;
    conditions.rating = rating;
    const Region first(one, conditions), second(other, conditions);
    expect_same(first.greatest_speed_rad_s(), second.greatest_speed_rad_s());
    for (double speed_rad_s = -60.0; speed_rad_s <= 60.0; speed_rad_s += 1.25) {
      const JointRange a = first.at(speed_rad_s), b = second.at(speed_rad_s);
      ASSERT_EQ(a.is_empty, b.is_empty) << speed_rad_s;
      if (a.is_empty) continue;
      EXPECT_NEAR(a.least.torque_Nm, b.least.torque_Nm, 1e-9) << speed_rad_s;
      EXPECT_NEAR(a.greatest.torque_Nm, b.greatest.torque_Nm, 1e-9) << speed_rad_s;
    }
  }
}

TEST(Statements, GiveTheSameCheckOfAMotion) {
  const test::ScratchFolder folder;
  CheckReport reports[2];
  const Actuator actuators[] = {read(plain()).actuator, read(restated()).actuator};
  for (int i = 0; i < 2; ++i) {
    CheckRequest request;
    request.drives = {{"k", &actuators[i], {}}};
    request.trajectory = folder.write("m.csv",
                                      "time_s,k_position_rad,k_velocity_rad_s,k_torque_Nm\n"
                                      "0,0,0,0\n0.1,0.05,1,30\n0.2,0.2,2,-20\n0.3,0.4,1,5\n");
    reports[i] = check(request);
  }
  const CheckedInterpretation& one = reports[0].drives[0].interpretation;
  const CheckedInterpretation& other = reports[1].drives[0].interpretation;
  EXPECT_EQ(reports[0].verdict, reports[1].verdict);
  EXPECT_EQ(reports[0].findings.size(), reports[1].findings.size());
  expect_same(one.margin_Nm, other.margin_Nm);
  expect_same(one.rms_current_A, other.rms_current_A);
  expect_same(*one.continuous_current.limit, *other.continuous_current.limit);
  EXPECT_EQ(one.is_rated_at_joint, other.is_rated_at_joint);
  expect_same(one.continuous_torque.rms, other.continuous_torque.rms);
}

// A side of a current, an ampere of a torque, anything of a condition: refused by name.
TEST(Statements, RefuseWhatMakesNoSense) {
  for (const auto& [pointer, value] : {
           std::pair{"/motor/torque_constant_Nm_A", R"({"value": 1.6, "ampere": "rms"})"},
           {"/motor/resistance_ohm", R"({"value": 0.3, "side": "joint"})"},
           {"/drive/peak_current_A", R"({"value": 30, "side": "joint"})"},
           {"/drive/peak_current_A", R"({"value": 30, "ampere": "peak_phase"})"},
           {"/drive/peak_current_A", R"({"value": 30, "tolerance": -0.1})"},
           {"/drive/peak_current_A", R"({"ampere": "rms"})"},
           {"/drive/bus_voltage_V", R"({"value": 48})"},
           {"/datasheet/rated_torque_Nm", R"({"value": 2, "ampere": "rms"})"},
           {"/datasheet/voltage_V", R"({"value": 48})"},
       }) {
    json document = plain();
    document[json::json_pointer(pointer)] = json::parse(value);
    const std::vector<io::Fault> faults = faults_of(document);
    ASSERT_EQ(faults.size(), 1u) << pointer << value;
    EXPECT_TRUE(faults[0].path.starts_with(pointer)) << faults[0].path;
  }
}

// 160 Nm/A over 8 and 0.8 are 25 Nm/A at the motor, where 10 are the most. Amperes are compared in
// one kind: 31 rms are 43.8 of amplitude.
TEST(Statements, AreJudgedAtTheMotor) {
  json document = restated();
  document["motor"]["torque_constant_Nm_A"]["value"] = 160;
  ASSERT_EQ(faults_of(document).size(), 1u);
  EXPECT_EQ(faults_of(document)[0].path, "/motor/torque_constant_Nm_A/value");
  EXPECT_EQ(faults_of(document)[0].message, "is 25 Nm/A at the motor, outside [1e-05, 10] Nm/A");
  document = plain();
  document["drive"]["peak_current_A"] = {{"value", 42}, {"ampere", "peak"}};
  document["drive"]["continuous_current_A"] = 29;
  EXPECT_TRUE(faults_of(document).empty());
  document["drive"]["continuous_current_A"] = 31;
  ASSERT_EQ(faults_of(document).size(), 1u);
  EXPECT_EQ(faults_of(document)[0].path, "/drive/continuous_current_A");
}

}  // namespace
}  // namespace torquewright::actuator
