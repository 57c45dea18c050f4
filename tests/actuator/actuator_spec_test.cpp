// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/actuator_spec.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "actuator/motor/derived_values_spec.hpp"
#include "actuator/motor/statement.hpp"
#include "actuator/region/left_out.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "gearbox/problem_spec.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/strength/torque_limit.hpp"
#include "gearbox/topologies/topology.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

json contract_example() {
  return json::parse(R"({"kind": "actuator", "version": 1, "name": "knee D151",
   "motor": {"torque_constant_Nm_A": 0.32, "torque_constant_convention": "dc",
     "back_emf_constant_V_s_rad": 0.32, "resistance_ohm": 0.28, "resistance_convention": "dc",
     "inductance_d_H": 0, "inductance_q_H": 0, "pole_pairs": 21,
     "rotor_inertia_kg_m2": 0.000922, "winding_temperature_K": 298.15},
   "drive": {"bus_voltage_V": 67.2, "peak_current_A": 50, "continuous_current_A": 20,
     "modulation": "svpwm", "field_weakening": false, "regeneration": true},
   "battery": {"series_cells": 16, "parallel_cells": 4, "cell_open_circuit_V": 4.2,
     "cell_resistance_ohm": 0.015},
   "thermal": {"winding_to_case_K_W": 1.0, "case_to_ambient_K_W": 1.0, "winding_J_K": 50,
     "case_J_K": 500, "winding_limit_K": 393.15},
   "gearbox": {"ratio": 20, "forward_efficiency": 1, "backward_efficiency": 1},
   "effects": [{"effect": "coulomb_friction", "parameters": {"coulomb_Nm": 0.5},
     "provenance": "assumed"}],
   "assumed": ["/motor/resistance_ohm"]})");
}

json published_gearbox() {
  return {{"kind", "gearbox"},
          {"version", 1},
          {"topology", "3k"},
          {"teeth",
           {{"sun", 44},
            {"planet_1", 44},
            {"planet_2", 32},
            {"fixed_ring", 132},
            {"output_ring", 120}}},
          {"planet_count", 4},
          {"module_mm", 0.6}};
}

class ActuatorSpec : public ::testing::Test {
 protected:
  std::string written(const json& document) {
    const auto file = folder_.path() / "actuator.json";
    std::ofstream(file) << document;
    return file.string();
  }

  std::vector<io::Fault> faults_of(const json& document) {
    try {
      read_actuator(written(document));
    } catch (const io::SpecError& error) {
      return error.faults();
    }
    return {};
  }

  test::ScratchFolder folder_;
};

/// The same drive as a sheet prints it that knows neither torque constant nor currents.
json as_printed() {
  json document = contract_example();
  document["motor"].erase("torque_constant_Nm_A");
  document["motor"].erase("torque_constant_convention");
  document["motor"].erase("back_emf_constant_V_s_rad");
  document["motor"]["velocity_constant_rpm_V"] = 30;
  document["drive"].erase("peak_current_A");
  document["drive"].erase("continuous_current_A");
  document["drive"]["peak_torque_Nm"] = 288;
  document["drive"]["continuous_torque_Nm"] = {{"value", 12000}, {"unit", "Ncm"}};
  document["gearbox"]["forward_efficiency"] = 0.9;
  return document;
}

// Oracle: closed forms. Kv = 30 rpm/V is pi rad/s per volt, so that Kt = 1 / pi; at the joint an
// ampere is 20 * 0.9 / pi Nm, and 288 Nm are 16 pi amperes, 120 Nm 20 pi / 3.
TEST_F(ActuatorSpec, TakesWhatASheetPrintsInThePlaceOfConstantAndCurrents) {
  const ReadActuator read = read_actuator(written(as_printed()));
  const Actuator& actuator = read.actuator;
  constexpr double kRoundOff = 1e-14;
  const double pi = std::numbers::pi;
  EXPECT_NEAR(actuator.motor.torque_constant_Nm_A, 1.0 / pi, kRoundOff);
  EXPECT_EQ(actuator.motor.torque_constant_convention, CurrentConvention::kDc);
  EXPECT_NEAR(actuator.drive.peak_current_A / (16.0 * pi), 1.0, kRoundOff);
  EXPECT_NEAR(*actuator.drive.continuous_current_A / (20.0 * pi / 3.0), 1.0, kRoundOff);
  EXPECT_EQ(derived_values(read.documents.front(), actuator),
            (std::vector<std::string>{
                "torque constant 0.3183 Nm/A = 60 / (2 pi Kv), Kv = 30 rpm/V",
                "peak current 50.27 A = T / (Kt N eta), T = 288 Nm at the joint; friction is not "
                "counted",
                "continuous current 20.94 A = T / (Kt N eta), T = 120 Nm at the joint; friction is "
                "not counted"}));
  const ReadActuator stated = read_actuator(written(contract_example()));
  EXPECT_TRUE(derived_values(stated.documents.front(), stated.actuator).empty());
}

TEST_F(ActuatorSpec, RefusesConstantsAndCurrentsThatStandTwiceOrNowhere) {
  json twice = contract_example();
  twice["motor"]["velocity_constant_rpm_V"] = 30;
  twice["drive"]["peak_torque_Nm"] = 288;
  auto faults = faults_of(twice);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].path, "/motor/velocity_constant_rpm_V");
  EXPECT_EQ(faults[1].path, "/drive/peak_torque_Nm");
  json nowhere = as_printed();
  nowhere["motor"].erase("velocity_constant_rpm_V");
  nowhere["drive"].erase("peak_torque_Nm");
  faults = faults_of(nowhere);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].message, "missing; or \"velocity_constant_rpm_V\", from which it follows");
  EXPECT_EQ(faults[1].message, "missing; or \"peak_torque_Nm\", from which it follows");
  json other = as_printed();
  other["motor"]["torque_constant_convention"] = "rms_phase";
  faults = faults_of(other);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].path, "/motor/torque_constant_convention");
  json huge = as_printed();
  huge["drive"]["peak_torque_Nm"] = 1e6;
  faults = faults_of(huge);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].path, "/drive/peak_torque_Nm");
}

TEST_F(ActuatorSpec, ReadsTheContractsExample) {
  const Actuator actuator = read_actuator(written(contract_example())).actuator;
  EXPECT_EQ(actuator.name, "knee D151");
  EXPECT_EQ(actuator.motor.torque_constant_Nm_A, 0.32);
  EXPECT_EQ(actuator.effects.size(), 1u);
  EXPECT_EQ(actuator.battery->parallel_cells, 4.0);
  EXPECT_TRUE(objections(actuator, {}).empty());
}

struct BadKey {
  const char* pointer;
  json value;
};

TEST_F(ActuatorSpec, RefusesWhatIsImplausible) {
  for (const BadKey& bad :
       {BadKey{"/motor/resistance_ohm", 0.0}, BadKey{"/motor/rotor_inertia_kg_m2", -1e-3},
        BadKey{"/motor/torque_constant_Nm_A", 320.0},  // mNm/A by mistake
        BadKey{"/motor/torque_constant_convention", "rms"}, BadKey{"/drive/bus_voltage_V", -48},
        BadKey{"/drive/continuous_current_A", 60}, BadKey{"/gearbox/forward_efficiency", 1.2},
        BadKey{"/gearbox/ratio", 0}, BadKey{"/thermal/winding_limit_K", 290},
        BadKey{"/effects/0/effect", "coulomb_fricton"},
        BadKey{"/effects/0/parameters/coulomb_Nm", -1.0}, BadKey{"/motor/resistance", 0.2},
        BadKey{"/battery/cell_open_circuit_V", json::array()}}) {
    json document = contract_example();
    document[json::json_pointer(bad.pointer)] = bad.value;
    const std::vector<io::Fault> faults = faults_of(document);
    ASSERT_FALSE(faults.empty()) << bad.pointer;
    EXPECT_TRUE(faults.front().path.starts_with(bad.pointer)) << faults.front().path;
  }
}

TEST_F(ActuatorSpec, ReadsWhatIdentificationWrote) {
  json document = contract_example();
  json& effect = document["effects"][0];
  effect["standard_error"] = {{"coulomb_Nm", 0.01}};
  effect["provenance"] = {{"source", "identified"},
                          {"logs", {{{"path", "a.csv"}, {"sha256", "00"}}}},
                          {"holdout_rms_before", 0.5},
                          {"holdout_rms_after", nullptr},
                          {"unit", "Nm"}};
  EXPECT_EQ(read_actuator(written(document)).actuator.effects[0].provenance, "identified");
  effect["provenance"].erase("source");
  ASSERT_EQ(faults_of(document).size(), 1u);
  EXPECT_EQ(faults_of(document)[0].path, "/effects/0/provenance/source");
}

TEST_F(ActuatorSpec, RefusesEffectsThatCountTwice) {
  json document = contract_example();
  document["effects"].push_back(document["effects"][0]);
  EXPECT_EQ(faults_of(document).size(), 1u);
  document["effects"][1] = {
      {"effect", "stribeck_friction"},
      {"replaces", "coulomb_friction"},
      {"parameters",
       {{"coulomb_Nm", 0.5}, {"breakaway_Nm", 0.8}, {"stribeck_velocity_rad_s", 0.1}}}};
  const std::vector<io::Fault> faults = faults_of(document);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults.front().path, "/effects/1/replaces");
}

// Oracle: what was written. A region takes the bound itself, which counts as assumed and is said; a
// torque per ampere is at most what a Kv of at least 30 rpm/V leaves.
TEST_F(ActuatorSpec, TakesABoundForTheNumberAndSaysSo) {
  json document = contract_example();
  document["drive"]["peak_current_A"] = {{"value", 45}, {"bound", "at_least"}};
  document["motor"].erase("torque_constant_Nm_A");
  document["motor"].erase("torque_constant_convention");
  document["motor"]["velocity_constant_rpm_V"] = {{"value", 30}, {"bound", "at_least"}};
  document["assumed"] = {"/motor"};
  const ReadActuator read = read_actuator(written(document));
  EXPECT_EQ(read.actuator.drive.peak_current_A, 45.0);
  EXPECT_EQ(read.actuator.assumed, (std::vector<std::string>{"/motor", "/drive/peak_current_A"}));
  const Statement* constant = find_statement(read.actuator, "/motor/torque_constant_Nm_A");
  ASSERT_NE(constant, nullptr);
  EXPECT_EQ(constant->bound, Bound::kAtMost);
  const std::vector<std::string> said = derived_values(read.documents.front(), read.actuator);
  EXPECT_EQ(said.at(0),
            "/motor/velocity_constant_rpm_V is stated as at least 30, and taken as that");
  EXPECT_EQ(said.at(1), "/drive/peak_current_A is stated as at least 45, and taken as that");
}

struct Figure {
  const char* pointer;
  double value;
  double (*read)(const Actuator&);
};

// Oracle: the number that was written: another than the example's and than that of an absent key.
TEST_F(ActuatorSpec, ReadsEveryFigure) {
  const Figure figures[] = {
      {"/mass_kg", 3, [](const Actuator& a) { return a.mass_kg.value(); }},
      {"/motor/torque_constant_Nm_A", 0.4,
       [](const Actuator& a) { return a.motor.torque_constant_Nm_A; }},
      {"/motor/back_emf_constant_V_s_rad", 0.3,
       [](const Actuator& a) { return a.motor.back_emf_constant_V_s_rad.value(); }},
      {"/motor/resistance_ohm", 0.7, [](const Actuator& a) { return a.motor.resistance_ohm; }},
      {"/motor/inductance_d_H", 1e-4, [](const Actuator& a) { return a.motor.inductance_d_H; }},
      {"/motor/inductance_q_H", 2e-4, [](const Actuator& a) { return a.motor.inductance_q_H; }},
      {"/motor/pole_pairs", 7, [](const Actuator& a) { return a.motor.pole_pairs; }},
      {"/motor/rotor_inertia_kg_m2", 0.002,
       [](const Actuator& a) { return a.motor.rotor_inertia_kg_m2; }},
      {"/motor/winding_temperature_K", 310,
       [](const Actuator& a) { return a.motor.winding_temperature_K; }},
      {"/motor/demagnetisation_current_A", 90,
       [](const Actuator& a) { return a.motor.demagnetisation_current_A; }},
      {"/drive/bus_voltage_V", 36, [](const Actuator& a) { return a.drive.bus_voltage_V; }},
      {"/drive/peak_current_A", 45, [](const Actuator& a) { return a.drive.peak_current_A; }},
      {"/drive/continuous_current_A", 25,
       [](const Actuator& a) { return a.drive.continuous_current_A.value(); }},
      {"/drive/supply_current_A", 30, [](const Actuator& a) { return a.drive.supply_current_A; }},
      {"/drive/regeneration_limit_W", 80,
       [](const Actuator& a) { return a.drive.regeneration_limit_W; }},
      {"/battery/series_cells", 12, [](const Actuator& a) { return a.battery->series_cells; }},
      {"/battery/parallel_cells", 3, [](const Actuator& a) { return a.battery->parallel_cells; }},
      {"/battery/cell_open_circuit_V", 3.7,
       [](const Actuator& a) { return a.battery->cell_open_circuit.at(0).voltage_V; }},
      {"/battery/cell_resistance_ohm", 0.03,
       [](const Actuator& a) { return a.battery->cell_resistance_ohm; }},
      {"/battery/wiring_resistance_ohm", 0.01,
       [](const Actuator& a) { return a.battery->wiring_resistance_ohm; }},
      {"/battery/discharge_limit_A", 70,
       [](const Actuator& a) { return a.battery->discharge_limit_A; }},
      {"/battery/charge_limit_A", 20, [](const Actuator& a) { return a.battery->charge_limit_A; }},
      {"/battery/maximum_voltage_V", 68,
       [](const Actuator& a) { return a.battery->maximum_voltage_V; }},
      {"/thermal/winding_to_case_K_W", 1.5,
       [](const Actuator& a) { return a.thermal->winding_to_case_K_W; }},
      {"/thermal/case_to_ambient_K_W", 2.5,
       [](const Actuator& a) { return a.thermal->case_to_ambient_K_W; }},
      {"/thermal/winding_J_K", 40, [](const Actuator& a) { return a.thermal->winding_J_K; }},
      {"/thermal/case_J_K", 400, [](const Actuator& a) { return a.thermal->case_J_K; }},
      {"/thermal/winding_limit_K", 400,
       [](const Actuator& a) { return a.thermal->winding_limit_K; }},
      {"/thermal/ambient_K", 305, [](const Actuator& a) { return a.thermal->ambient_K; }},
      {"/gearbox/ratio", -9, [](const Actuator& a) { return a.transmission.ratio; }},
      {"/gearbox/forward_efficiency", 0.9,
       [](const Actuator& a) { return a.transmission.forward_efficiency; }},
      {"/gearbox/backward_efficiency", 0.8,
       [](const Actuator& a) { return a.transmission.backward_efficiency; }},
      {"/gearbox/inertia_kg_m2", 0.05,
       [](const Actuator& a) { return a.transmission.inertia_kg_m2; }},
      {"/gearbox/peak_torque_Nm", 200,
       [](const Actuator& a) { return a.transmission.peak_torque_Nm; }},
      {"/datasheet/voltage_V", 24,
       [](const Actuator& a) { return a.datasheet->voltage_V.value(); }},
      {"/datasheet/no_load_speed_rad_s", 30,
       [](const Actuator& a) { return a.datasheet->no_load_speed_rad_s.value(); }},
      {"/datasheet/no_load_current_A", 0.6,
       [](const Actuator& a) { return a.datasheet->no_load_current_A.value(); }},
      {"/datasheet/stall_torque_Nm", 50,
       [](const Actuator& a) { return a.datasheet->stall_torque_Nm.value(); }},
      {"/datasheet/stall_current_A", 60,
       [](const Actuator& a) { return a.datasheet->stall_current_A.value(); }},
      {"/datasheet/peak_torque_Nm", 40,
       [](const Actuator& a) { return a.datasheet->peak_torque_Nm.value(); }},
      {"/datasheet/peak_torque_current_A", 48,
       [](const Actuator& a) { return a.datasheet->peak_torque_current_A.value(); }},
      {"/datasheet/peak_braking_torque_Nm", 52,
       [](const Actuator& a) { return a.datasheet->peak_braking_torque_Nm.value(); }},
      {"/datasheet/rated_torque_Nm", 15,
       [](const Actuator& a) { return a.datasheet->rated_torque_Nm.value(); }},
      {"/datasheet/peak_power_W", 900,
       [](const Actuator& a) { return a.datasheet->peak_power_W.value(); }},
      {"/datasheet/velocity_constant_rpm_V", 33,
       [](const Actuator& a) { return a.datasheet->velocity_constant_rpm_V.value(); }},
      {"/datasheet/reflected_inertia_kg_m2", 0.4,
       [](const Actuator& a) { return a.datasheet->reflected_inertia_kg_m2.value(); }},
      {"/datasheet/electrical_time_constant_s", 0.001,
       [](const Actuator& a) { return a.datasheet->electrical_time_constant_s.value(); }},
      {"/datasheet/mechanical_time_constant_s", 0.02,
       [](const Actuator& a) { return a.datasheet->mechanical_time_constant_s.value(); }},
  };
  for (const Figure& figure : figures) {
    SCOPED_TRACE(figure.pointer);
    json document = contract_example();
    document[json::json_pointer(figure.pointer)] = figure.value;
    EXPECT_EQ(figure.read(read_actuator(written(document)).actuator), figure.value);
  }
}

// Oracle: the words that the conventions themselves are printed as.
TEST_F(ActuatorSpec, ReadsEveryWord) {
  const auto with = [&](const char* pointer, const json& value) {
    json document = contract_example();
    document[json::json_pointer(pointer)] = value;
    return read_actuator(written(document)).actuator;
  };
  for (const char* word : {"dc", "peak_phase", "rms_phase"}) {
    EXPECT_EQ(
        name_of(with("/motor/torque_constant_convention", word).motor.torque_constant_convention),
        word);
  }
  for (const char* word : {"dc", "phase", "line_to_line"}) {
    EXPECT_EQ(name_of(with("/motor/resistance_convention", word).motor.resistance_convention),
              word);
  }
  for (const char* word : {"sine", "svpwm", "six_step"}) {
    EXPECT_EQ(name_of(with("/drive/modulation", word).drive.modulation), word);
  }
  EXPECT_FALSE(with("/drive/regeneration", false).drive.regeneration);
  EXPECT_TRUE(with("/datasheet/side", "joint").datasheet->joint_side);
  EXPECT_FALSE(with("/datasheet/side", "motor").datasheet->joint_side);
  EXPECT_EQ(with("/assumed", {"/motor"}).assumed, std::vector<std::string>{"/motor"});
}

// Oracle: docs/actuator_documents.md, what an absent key stands for.
TEST_F(ActuatorSpec, KnowsWhatAbsentKeysStandFor) {
  json document = contract_example();
  document.merge_patch(json::parse(R"({"name": null, "assumed": null, "effects": null,
    "motor": {"back_emf_constant_V_s_rad": null, "inductance_d_H": null, "inductance_q_H": null,
      "pole_pairs": null, "rotor_inertia_kg_m2": null, "winding_temperature_K": null},
    "drive": {"continuous_current_A": null, "modulation": null, "field_weakening": null,
      "regeneration": null}})"));
  const Actuator actuator = read_actuator(written(document)).actuator;
  EXPECT_EQ(actuator.name, "actuator");  // the file's
  EXPECT_FALSE(actuator.mass_kg || actuator.datasheet);
  EXPECT_TRUE(actuator.effects.empty() && actuator.assumed.empty());
  const Motor& motor = actuator.motor;
  EXPECT_FALSE(motor.back_emf_constant_V_s_rad);
  EXPECT_EQ(motor.inductance_d_H, 0.0);
  EXPECT_EQ(motor.inductance_q_H, 0.0);
  EXPECT_EQ(motor.pole_pairs, 1.0);
  EXPECT_EQ(motor.rotor_inertia_kg_m2, 0.0);
  EXPECT_EQ(motor.winding_temperature_K, 298.15);
  EXPECT_EQ(motor.demagnetisation_current_A, kUnlimited);
  const Drive& drive = actuator.drive;
  EXPECT_FALSE(drive.continuous_current_A);
  EXPECT_EQ(drive.modulation, Modulation::kSvpwm);
  EXPECT_FALSE(drive.field_weakening);
  EXPECT_TRUE(drive.regeneration);
  EXPECT_EQ(drive.supply_current_A, kUnlimited);
  EXPECT_EQ(drive.regeneration_limit_W, kUnlimited);
  EXPECT_EQ(actuator.battery->wiring_resistance_ohm, 0.0);
  EXPECT_EQ(actuator.battery->discharge_limit_A, kUnlimited);
  EXPECT_EQ(actuator.battery->charge_limit_A, kUnlimited);
  EXPECT_EQ(actuator.battery->maximum_voltage_V, kUnlimited);
  EXPECT_EQ(actuator.battery->cell_open_circuit, (std::vector<ChargePoint>{{1.0, 4.2}}));
  EXPECT_EQ(actuator.thermal->ambient_K, 298.15);
  EXPECT_EQ(actuator.transmission.inertia_kg_m2, 0.0);
  EXPECT_EQ(actuator.transmission.peak_torque_Nm, kUnlimited);
}

struct Patched {
  const char* patch;  ///< Of the contract's example.
  const char* fault;  ///< Path and message; empty: it is good.
};

// What the schema alone cannot tell: keys that contradict each other, and the last values that do
// not.
TEST_F(ActuatorSpec, RefusesKeysThatContradictEachOther) {
  const char* poles = "/motor/pole_pairs: missing; the voltage over an inductance needs it";
  const char* ascent =
      "/battery/cell_open_circuit_V/1: must ascend: more charge than the entry before, and no less "
      "voltage";
  for (const Patched& patched : {
           Patched{R"({"motor": {"pole_pairs": null, "inductance_d_H": 1e-4}})", poles},
           {R"({"motor": {"pole_pairs": null, "inductance_q_H": 1e-4}})", poles},
           {R"({"motor": {"pole_pairs": null}})", ""},
           {R"({"motor": {"torque_constant_convention": "rms_phase"},
                "drive": {"modulation": null}})",
            "/drive/modulation: missing; outside the dc convention it sets the voltage: sine, "
            "svpwm or six_step"},
           {R"({"motor": {"torque_constant_convention": "rms_phase"}})", ""},
           {R"({"drive": {"continuous_current_A": 50.5}})",
            "/drive/continuous_current_A: 50.5 is above /drive/peak_current_A, 50"},
           {R"({"drive": {"continuous_current_A": 50}})", ""},
           {R"({"drive": {"field_weakening": true}})",
            "/drive/field_weakening: needs /motor/inductance_d_H: without inductance no current "
            "weakens the field"},
           {R"({"drive": {"field_weakening": true}, "motor": {"inductance_d_H": 1e-4}})", ""},
           {R"({"battery": {"cell_open_circuit_V": [{"state_of_charge": 0.5, "voltage_V": 3.5},
                {"state_of_charge": 0.5, "voltage_V": 3.6}]}})",
            ascent},
           {R"({"battery": {"cell_open_circuit_V": [{"state_of_charge": 0.5, "voltage_V": 3.5},
                {"state_of_charge": 0.6, "voltage_V": 3.4}]}})",
            ascent},
           {R"({"battery": {"cell_open_circuit_V": [{"state_of_charge": 0.5, "voltage_V": 3.5},
                {"state_of_charge": 0.6, "voltage_V": 3.5}]}})",
            ""},
           {R"({"effects": [{"effect": "coulomb_friction", "provenance": "assumed",
                "parameters": {"coulomb_Nm": -5}}]})",
            "/effects/0/parameters/coulomb_Nm: -5 is outside what is possible, 0 or more Nm: "
            "Torque "
            "at the output."},
           {R"({"effects": [{"effect": "torque_constant_temperature", "provenance": "assumed",
                "parameters": {"coefficient_1_K": 1}}]})",
            "/effects/0/parameters/coefficient_1_K: 1 is outside what is possible, -0.01 to 0.01 "
            "1/K: Relative change per kelvin."},
           {R"({"thermal": {"winding_limit_K": 298.15}})",
            "/thermal/winding_limit_K: 298.15 K is not above the ambient's 298.15 K"},
           {R"({"thermal": {"winding_limit_K": 298.16}})", ""},
           {R"({"gearbox": {"ratio": -0.0099}})",
            "/gearbox/ratio: -0.0099 is no ratio; must be at least 0.01 in magnitude"},
           {R"({"gearbox": {"ratio": -0.01}})", ""},
           {R"({"effects": [
                {"effect": "viscous_friction", "parameters": {"viscous_Nm_s_rad": 0.1}},
                {"effect": "coulomb_friction", "parameters": {"coulomb_Nm": 0.5}},
                {"effect": "coulomb_friction", "parameters": {"coulomb_Nm": 0.5}}]})",
            "/effects/2/effect: coulomb_friction stands twice; one of them would be counted "
            "twice"},
           {R"({"effects": [
                {"effect": "viscous_friction", "parameters": {"viscous_Nm_s_rad": 0.1}},
                {"effect": "coulomb_friction", "parameters": {"coulomb_Nm": 0.5}},
                {"effect": "stribeck_friction", "replaces": "coulomb_friction", "parameters":
                  {"coulomb_Nm": 0.5, "breakaway_Nm": 0.8, "stribeck_velocity_rad_s": 0.1}}]})",
            "/effects/2/replaces: coulomb_friction is declared besides what replaces it and would "
            "be counted twice; remove it"},
       }) {
    json document = contract_example();
    document.merge_patch(json::parse(patched.patch));
    std::string found;
    for (const io::Fault& fault : faults_of(document)) found += fault.path + ": " + fault.message;
    EXPECT_EQ(found, patched.fault) << patched.patch;
  }
}

// Oracle: efficiencies of the published D151 row, 44/44/32/132/120, follow from its teeth, whatever
// the actuator's document says: a separate program, from the contact path to the shaft powers (the
// same as in tests/gearbox/train/losses_test.cpp).
TEST_F(ActuatorSpec, ComputesAGearboxInAFile) {
  std::ofstream(folder_.path() / "gearbox.json") << published_gearbox();
  json document = contract_example();
  document["gearbox"] = {{"file", "gearbox.json"}, {"friction_coefficient", 0.08}};
  const ReadActuator read = read_actuator(written(document));
  EXPECT_EQ(read.actuator.transmission.ratio, 20.0);
  EXPECT_NEAR(read.actuator.transmission.forward_efficiency, 0.9567542077021693, 1e-12);
  EXPECT_NEAR(read.actuator.transmission.backward_efficiency, 0.9552021076343958, 1e-12);
  EXPECT_EQ(read.documents.size(), 2u);
  document["gearbox"].erase("friction_coefficient");
  const std::vector<io::Fault> faults = faults_of(document);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults.front().path, "/gearbox/friction_coefficient");
}

// Oracle: gearbox/strength, asked of the same teeth.
TEST_F(ActuatorSpec, TakesWhatTheTeethOfAResultBearAsTheGearsBound) {
  json problem = json::parse(R"({"kind": "gearbox_problem", "version": 1, "topology": "3k",
   "target_ratio": 20, "rotor_inner_diameter_mm": 79.4, "module_mm": 0.6, "planet_count": 4,
   "min_teeth": {"sun": 40, "planet_1": 40, "planet_2": 30}, "min_carrier_clearance_rad": 0.26,
   "constraints": "paper", "objective": "paper_cost", "friction_coefficient": 0.08,
   "face_width_mm": {"layer_1": 10, "layer_2": 10}, "materials": {"steel": "case_hardened"}})");
  const auto read_with = [&](const json& asked) {
    json result = {{"kind", "gearbox_result"},
                   {"version", 1},
                   {"status", "optimal"},
                   {"objective", 1.0},
                   {"bound", 1.0},
                   {"gap", 0.0},
                   {"problem", asked},
                   {"search", {{"nodes", 0}, {"relaxations", 0}}},
                   {"certificate", {{"version", 1}, {"claims", json::array()}}},
                   {"conflict", json::array()},
                   {"would_be_feasible_with", json::array()},
                   {"tool", {{"name", "torquewright"}, {"version", "0"}}},
                   {"inputs", json::array()}};
    const gearbox::Problem read =
        gearbox::read_problem(io::check_document(asked, "gearbox_problem", "problem.json", ""));
    const gearbox::Design design{{44, 44, 32, 132, 120}, 4, io::Rational(3, 5)};
    const gearbox::Topology& topology = *gearbox::find_topology("3k");
    result["designs"] = json::array(
        {json::parse(gearbox::report_json(topology, topology.evaluate(read, design)).dump())});
    std::ofstream(folder_.path() / "result.json") << result;
    json document = contract_example();
    document["gearbox"] = {{"file", "result.json"}};
    return read_actuator(written(document)).actuator;
  };
  const auto strength = gearbox::strength_of_design(
      gearbox::read_problem(io::check_document(problem, "gearbox_problem", "problem.json", "")),
      {{44, 44, 32, 132, 120}, 4, io::Rational(3, 5)});
  const Actuator bounded = read_with(problem);
  EXPECT_NEAR(bounded.transmission.peak_torque_Nm,
              gearbox::torque_limits(*strength).for_cycles.joint_Nm, 1e-9);
  EXPECT_LT(bounded.transmission.peak_torque_Nm, 320.0);
  for (const std::string& sentence : left_out(bounded, Part::kRegion)) {
    EXPECT_FALSE(sentence.starts_with("gear strength")) << sentence;
  }
  problem.erase("face_width_mm");
  const Actuator open = read_with(problem);
  EXPECT_EQ(open.transmission.peak_torque_Nm, kUnlimited);
  EXPECT_TRUE(left_out(open, Part::kRegion).front().starts_with("gear strength: "));
  EXPECT_TRUE(left_out(open, Part::kCheck).front().starts_with("gear strength: "));
}

// Oracle: the file system, in which the gearbox is no more.
TEST_F(ActuatorSpec, OpensNoFileThatWasReadBefore) {
  std::ofstream(folder_.path() / "gearbox.json") << published_gearbox();
  json document = contract_example();
  document["gearbox"] = {{"file", "gearbox.json"}, {"friction_coefficient", 0.08}};
  const ReadActuator read = read_actuator(written(document));
  std::filesystem::remove(folder_.path() / "gearbox.json");
  EXPECT_THROW(read_actuator(read.documents.front()), io::SpecError);
  const ReadActuator again = read_actuator(read.documents.front(), read.documents);
  EXPECT_EQ(again.actuator.transmission.ratio, 20.0);
  EXPECT_EQ(again.documents.size(), 2u);
}

TEST_F(ActuatorSpec, RefusesGearsThatItCannotCompute) {
  const auto faults_with = [&](const char* patch) {
    json gearbox = published_gearbox();
    gearbox.merge_patch(json::parse(patch));
    std::ofstream(folder_.path() / "gearbox.json") << gearbox;
    json document = contract_example();
    document["gearbox"] = {{"file", "gearbox.json"}, {"friction_coefficient", 0.08}};
    std::string found;
    for (const io::Fault& fault : faults_of(document)) found += fault.path + ": " + fault.message;
    return found;
  };
  EXPECT_EQ(faults_with("{}"), "");
  EXPECT_EQ(faults_with(R"({"profile_shift": {"sun": 0}})"), "");
  // Sun and planet move apart, the rings do not.
  EXPECT_EQ(faults_with(R"({"profile_shift": {"fixed_ring": 0, "sun": 0.2}})").substr(0, 47),
            "/profile_shift: coaxial.fixed_ring: 0.2 modules");
  EXPECT_EQ(faults_with(R"({"profile_shift": {"sun": -2}})").substr(0, 33),
            ": the profile shifts -2, 0 of sun");
  EXPECT_EQ(faults_with(R"({"teeth": {"planet_2": null}})"),
            "/teeth/planet_2: missing; the topology \"3k\" has it");
  // A ring smaller than the planet inside it.
  EXPECT_EQ(faults_with(R"({"teeth": {"fixed_ring": 40}})"),
            ": the mesh planet_1_fixed_ring does not exist for these teeth");
}

// Oracle: the result's own figures; the inertia is that of the gears alone, whatever rotor the
// search assumed: the actuator states its own.
TEST_F(ActuatorSpec, TakesTheFirstDesignOfASearch) {
  std::ifstream in(std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) /
                   "specs/gearbox/d151_knee_result.json");
  json result = json::parse(in);
  result["problem"]["materials"] = {{"density_kg_m3", 7850}};
  result["problem"]["face_width_mm"] = {{"layer_1", 10}, {"layer_2", 10}};
  json document = contract_example();
  document["gearbox"] = {{"file", "gearbox.json"}};
  const auto transmission_with = [&](double rotor_kg_m2) {
    result["problem"]["rotor_inertia_kg_m2"] = rotor_kg_m2;
    std::ofstream(folder_.path() / "gearbox.json") << result;
    return read_actuator(written(document)).actuator.transmission;
  };
  const Transmission heavy = transmission_with(0.01);
  EXPECT_EQ(heavy.ratio, 20.0);
  EXPECT_EQ(heavy.forward_efficiency, result["designs"][0]["forward_efficiency"].get<double>());
  EXPECT_EQ(heavy.backward_efficiency, result["designs"][0]["backward_efficiency"].get<double>());
  EXPECT_EQ(heavy.source, (folder_.path() / "gearbox.json").string());
  EXPECT_GT(heavy.inertia_kg_m2, 0.0);
  EXPECT_EQ(heavy.inertia_kg_m2, transmission_with(0.0).inertia_kg_m2);
  result["designs"] = json::array();
  std::ofstream(folder_.path() / "gearbox.json") << result;
  const std::vector<io::Fault> faults = faults_of(document);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].path, "/designs");
}

TEST_F(ActuatorSpec, RefusesAGearboxFileOfAnotherKind) {
  std::ofstream(folder_.path() / "other.json") << contract_example();
  json document = contract_example();
  document["gearbox"] = {{"file", "other.json"}, {"friction_coefficient", 0.08}};
  const std::vector<io::Fault> faults = faults_of(document);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults.front().path, "/kind");
}

}  // namespace
}  // namespace torquewright::actuator
