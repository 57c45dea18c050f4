// SPDX-License-Identifier: Apache-2.0
// `gearbox strength` as a user runs it: exit codes, both sides of a torque, and its JSON.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

const std::string kAnkle = in_repository("specs/gearbox/d110a_strength.json").string();

Outcome strength(std::vector<std::string> options) {
  options.insert(options.begin(), {"gearbox", "strength", kAnkle});
  return run(options);
}

TEST(Strength, ShowsATorqueOnBothSides) {
  const Outcome motor = strength({"--torque", "21"});
  EXPECT_EQ(motor.exit_code, 0);
  EXPECT_EQ(motor.err, "");
  EXPECT_NE(motor.out.find("\n21 Nm at the motor, 168 Nm at the joint: borne\n"), std::string::npos)
      << motor.out;
  EXPECT_EQ(strength({"--torque", "168", "--side", "joint"}).out, motor.out);
}

TEST(Strength, FailsWhereASafetyIsBelowTheDemandedOne) {
  const Outcome outcome = strength({"--torque", "17,60"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("\n17 Nm at the motor, 136 Nm at the joint: borne\n"),
            std::string::npos);
  EXPECT_NE(outcome.out.find("\n60 Nm at the motor, 480 Nm at the joint: BELOW"),
            std::string::npos);
}

TEST(Strength, GoesOverSizes) {
  const Outcome outcome = strength(
      {"--torque", "21,17", "--face-widths", "6,8,10,12", "--modules", "0.5,0.6,1", "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "strength_report"));
  ASSERT_EQ(report["other_sizes"].size(), 8u);  // a module of 1 mm leaves too few teeth
  EXPECT_EQ(report["left_out"].size(), 1u);
  for (const json& size : report["other_sizes"]) {
    EXPECT_EQ(size["loadings"][0]["joint_torque_Nm"], 168.0);
    EXPECT_EQ(size["loadings"][1]["joint_torque_Nm"], 136.0);
  }
}

// More loads are borne less well; the document's number gives way to the option's.
TEST(Strength, TakesTheNumberOfLoads) {
  const auto life = [](const char* cycles) {
    const json report = json::parse(strength({"--torque", "21", "--json", "--cycles", cycles}).out);
    return report["gearbox"]["greatest_torque"]["for_cycles"]["motor_torque_Nm"].get<double>();
  };
  EXPECT_GT(life("1"), life("1000000"));
}

TEST(Strength, RefusesWhatIsNoLoad) {
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--torque", "0"},
                                                        {"--torque", "nan"},
                                                        {"--torque", "-21"},
                                                        {"--face-widths", "inf"},
                                                        {"--modules", "0"},
                                                        {"--cycles", "0.5"}}) {
    std::vector<std::string> options{option, value};
    if (option != "--torque") options.insert(options.end(), {"--torque", "21"});
    const Outcome outcome = strength(options);
    EXPECT_EQ(outcome.exit_code, 2) << option << " " << value;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
}

TEST(Strength, AsksForRoomWhereModulesAreTried) {
  const Workplace place;
  place.write("ankle.json", with(text_of(kAnkle), "\"rotor_inner_diameter_mm\": 90,", ""));
  const std::string document = with(place.text("ankle.json"), "\"/rotor_inner_diameter_mm\",", "");
  place.write("ankle.json", document);
  const Outcome outcome =
      place.run({"gearbox", "strength", "ankle.json", "--torque", "21", "--modules", "0.5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "ankle.json#/rotor_inner_diameter_mm: missing; --modules chooses teeth that fit into "
            "it\n");
}

}  // namespace
}  // namespace torquewright::cli_test
