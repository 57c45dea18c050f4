// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/actuator_spec.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "actuator/region/operating_conditions.hpp"
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
