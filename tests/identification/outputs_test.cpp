// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/outputs/output.hpp"
#include "io/documents/document.hpp"
#include "tests/actuator/check/refusal.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

/// A drive of round numbers, N Kt = 1 Nm/A and R = 0.5 ohm, with these things changed.
actuator::Actuator drive_with(const char* changes) {
  json document = json::parse(R"({"kind": "actuator", "version": 1, "name": "drive",
    "motor": {"torque_constant_Nm_A": 0.1, "torque_constant_convention": "dc", "resistance_ohm": 0.5,
      "resistance_convention": "dc", "rotor_inertia_kg_m2": 2e-4},
    "drive": {"bus_voltage_V": 48, "peak_current_A": 100},
    "gearbox": {"ratio": 10, "forward_efficiency": 1, "backward_efficiency": 1}})");
  document.merge_patch(json::parse(changes));
  return actuator::read_actuator(io::check_document(document, "actuator", "a.json", ""), {})
      .actuator;
}

std::string written(const char* format, const char* changes, LoadType load = LoadType::kPendulum) {
  Load moved;
  moved.type = load;
  moved.mass_kg = 2.0;
  moved.length_m = 0.25;
  return output_of(format).write({drive_with(changes), moved});
}

double value_of(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name + " ");
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + name.size()));
}

constexpr double kPrinted = 1e-5;  ///< Of six digits.

// Oracle: closed form, c = 0.4 Nm, b = 0.2 Nm s/rad, eta = 0.8, 0.02 kg m^2 of the rotor and 0.125
// of the load: kS = 0.5 c, kV = 1 + 0.5 b, kA = 0.5 (0.02 + 0.125/0.8), kG = 0.5 m g l/0.8.
TEST(OutputAsFrc, HoldsFrictionAndLosses) {
  const std::string text = written("frc", R"({
      "gearbox": {"forward_efficiency": 0.8, "backward_efficiency": 0.8}, "effects": [
      {"effect": "coulomb_friction", "parameters": {"coulomb_Nm": 0.4}},
      {"effect": "viscous_friction", "parameters": {"viscous_Nm_s_rad": 0.2}},
      {"effect": "inverter_dead_time", "parameters": {"voltage_V": 0.3}},
      {"effect": "torque_lag", "parameters": {"time_constant_s": 0.001}}]})");
  EXPECT_NEAR(value_of(text, "kS"), 0.2 + 0.3, kPrinted) << text;
  EXPECT_NEAR(value_of(text, "kV"), 1.1, kPrinted);
  EXPECT_NEAR(value_of(text, "kA"), 0.5 * (0.02 + 0.15625), kPrinted);
  EXPECT_NEAR(value_of(text, "kG"), 0.5 * 2.0 * 9.81 * 0.25 / 0.8, kPrinted);
  EXPECT_NE(text.find("without a counterpart: torque_lag"), std::string::npos);
  EXPECT_EQ(text.find("friction is a curve"), std::string::npos);
}

// Oracle: c = 0.3 + 0.1 exp(-(w/1)^2) leaves the line by some of the 0.1 Nm, 0.5 V/Nm.
TEST(OutputAsFrc, SaysWhereItsLineIsOff) {
  const std::string text = written("frc", R"({"effects": [{"effect": "stribeck_friction",
      "parameters": {"coulomb_Nm": 0.3, "breakaway_Nm": 0.4, "stribeck_velocity_rad_s": 5}}]})");
  EXPECT_NEAR(value_of(text, "kS"), 0.15, 0.05);
  EXPECT_NE(text.find("friction is a curve: this line is off by"), std::string::npos) << text;
}

// What the line holds, though roughly, is not said to be missing; what stands at one angle is.
TEST(OutputAsFrc, HoldsEveryDragBySpeed) {
  const std::string text = written("frc", R"({"effects": [
      {"effect": "eddy_current_drag", "parameters": {"peak_Nm": 0.3, "critical_rad_s": 9}},
      {"effect": "position_dependent_friction", "parameters": {"harmonics":
          [{"order": 1, "amplitude_Nm": 0.1, "phase_rad": 0}]}}]})");
  EXPECT_NE(text.find("friction is a curve: this line is off by"), std::string::npos) << text;
  EXPECT_NE(text.find("without a counterpart: position_dependent_friction\n"), std::string::npos)
      << text;
}

// Oracle: 2 kg on a linear axis, no gravity.
TEST(OutputAsFrc, IsInMetresOnALinearAxis) {
  const std::string text = written("frc", "{}", LoadType::kLinearAxis);
  EXPECT_NE(text.find("V s/m\n"), std::string::npos) << text;
  EXPECT_NEAR(value_of(text, "kA"), 0.5 * (0.02 + 2.0), kPrinted);
  EXPECT_NE(text.find("the load has no gravity"), std::string::npos);
  EXPECT_NE(written("frc", "{}", LoadType::kDynamometer).find("own inertia alone"),
            std::string::npos);
}

TEST(OutputAs, RefusesConventionsThatItsModelDoesNotHave) {
  const char* const peak = R"({"motor": {"torque_constant_convention": "peak_phase",
      "resistance_convention": "phase"}, "drive": {"modulation": "svpwm"}})";
  for (const char* format : {"frc", "bam"}) {
    const std::string refusal = test::refusal([&] { written(format, peak); });
    EXPECT_NE(refusal.find("torque_constant_convention must be dc"), std::string::npos) << refusal;
  }
}

TEST(OutputAsBam, IsTheSimplestModelThatHoldsIt) {
  const json plain = json::parse(written("bam", R"({"effects": [
      {"effect": "coulomb_friction", "parameters": {"coulomb_Nm": 0.4}},
      {"effect": "viscous_friction", "parameters": {"viscous_Nm_s_rad": 0.2}}]})"));
  EXPECT_EQ(plain["model"], "m1");
  EXPECT_NEAR(plain["kt"].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(plain["R"], 0.5);
  EXPECT_NEAR(plain["armature"].get<double>(), 0.02, 1e-15);
  EXPECT_EQ(plain["friction_base"], 0.4);
  EXPECT_EQ(plain["friction_viscous"], 0.2);
  EXPECT_FALSE(plain.contains("notes"));
  EXPECT_FALSE(plain.contains("alpha"));
}

// Oracle: BAM's law (bam/model.py), by hand: friction |e external - m motor| at a load of 1 Nm.
TEST(OutputAsBam, HoldsLoadFrictionOfBothWays) {
  const json found = json::parse(written("bam", R"({
      "gearbox": {"forward_efficiency": 0.8, "backward_efficiency": 0.9},
      "effects": [{"effect": "stribeck_friction", "parameters":
      {"coulomb_Nm": 0.1, "breakaway_Nm": 0.15, "stribeck_velocity_rad_s": 0.3}}]})"));
  EXPECT_EQ(found["model"], "m5");
  const double e = found["load_friction_external"], m = found["load_friction_motor"];
  EXPECT_NEAR(std::abs(-e - m * 1.25), 0.25, 1e-12);  // 1.25 Nm of the motor drive 1 Nm.
  EXPECT_NEAR(std::abs(-e - m * 0.9), 0.1, 1e-12);    // 1 Nm drives 0.9 Nm back.
  EXPECT_NEAR(found["friction_stribeck"].get<double>(), 0.05, 1e-12);
  EXPECT_EQ(found["friction_base"], 0.1);
  EXPECT_EQ(found["dtheta_stribeck"], 0.3);
  EXPECT_EQ(found["alpha"], 2.0);
  EXPECT_NE(found["notes"][0].get<std::string>().find("a load friction is negative"),
            std::string::npos);
}

TEST(OutputAsBam, SaysWhatItHasNoCounterpartFor) {
  const json found = json::parse(written("bam", R"({"motor": {"back_emf_constant_V_s_rad": 0.12},
      "effects": [{"effect": "torque_lag", "parameters": {"time_constant_s": 0.001}}]})"));
  EXPECT_EQ(found["notes"][0], "without a counterpart: torque_lag");
  EXPECT_NE(found["notes"][1].get<std::string>().find("torque constant and back-EMF in one"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::identification
