// SPDX-License-Identifier: Apache-2.0
// What stands around a law: the JSON of a simulator file, the table of its errors, names and
// comments in the languages of the targets.
#include "actuator/exporters/simulator_file.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/library.hpp"
#include "actuator/exporters/simulator_file_json.hpp"
#include "actuator/exporters/text.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"

namespace torquewright::actuator {
namespace {

/// Figures each another.
ErrorReport errors() {
  ErrorReport report;
  report.greatest_speed_rad_s = 12.5;
  report.quadrants = {{{1, true, {1.0, 2.0}, {3.0, 4.0}},
                       {1, false, {5.0, 6.0}, {7.0, 8.0}},
                       {-1, true, {9.0, -10.0}, {11.0, -12.0}},
                       {-1, false, {0.0, 0.0}, {15.0, -16.0}}}};
  report.at_rest = {{{0, true, {17.0, 0.0}, {18.0, 0.0}}, {0, false, {19.0, 0.0}, {0.0, 0.0}}}};
  report.share_outside = 0.125;
  report.sentences = {"It is so."};
  return report;
}

SimulatorFile file_of(const Exporter& exporter, Shape shape) {
  SimulatorFile file;
  file.exporter = &exporter;
  file.shape = std::move(shape);
  file.errors = errors();
  file.text = "text";
  return file;
}

// Oracle: the figures put into it.
TEST(SimulatorFileJson, HoldsEveryFigureUnderItsKey) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kBest);
  const auto json = nlohmann::json::parse(
      simulator_file_json(subject, file_of(exporters::isaac_lab, {1500, 10, 300})).dump());
  EXPECT_EQ(json["kind"], "simulator_file");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["format"], "isaac-lab");
  EXPECT_EQ(json["fit"], "best");
  EXPECT_EQ(json["file"], "text");
  const auto& parameters = exporters::isaac_lab.parameters;
  ASSERT_EQ(json["parameters"].size(), 3u);
  EXPECT_EQ(json["parameters"][std::string(parameters[0].name)], 1500.0);
  EXPECT_EQ(json["parameters"][std::string(parameters[1].name)], 10.0);
  EXPECT_EQ(json["parameters"][std::string(parameters[2].name)], 300.0);
  EXPECT_NEAR(json["armature_kg_m2"].get<double>(), 400 * 0.000922, 1e-15);
  EXPECT_EQ(json["side"], "joint");  // of the region's own documents
  EXPECT_FALSE(json.contains("rows"));
  EXPECT_FALSE(json.contains("interpolation_error_Nm"));
  EXPECT_EQ(json["greatest_speed_rad_s"], 12.5);
  EXPECT_EQ(json["share_outside"], 0.125);
  EXPECT_EQ(json["sentences"], nlohmann::json({"It is so."}));
  EXPECT_EQ(json["errors"], nlohmann::json::parse(R"([
    {"speed": "positive", "bound": "upper", "mode": "driving",
     "optimistic": {"torque_Nm": 1.0, "speed_rad_s": 2.0},
     "cautious": {"torque_Nm": 3.0, "speed_rad_s": 4.0}},
    {"speed": "positive", "bound": "lower", "mode": "braking",
     "optimistic": {"torque_Nm": 5.0, "speed_rad_s": 6.0},
     "cautious": {"torque_Nm": 7.0, "speed_rad_s": 8.0}},
    {"speed": "negative", "bound": "upper", "mode": "braking",
     "optimistic": {"torque_Nm": 9.0, "speed_rad_s": -10.0},
     "cautious": {"torque_Nm": 11.0, "speed_rad_s": -12.0}},
    {"speed": "negative", "bound": "lower", "mode": "driving",
     "optimistic": {"torque_Nm": 0.0, "speed_rad_s": 0.0},
     "cautious": {"torque_Nm": 15.0, "speed_rad_s": -16.0}},
    {"speed": "zero", "bound": "upper", "mode": "at rest",
     "optimistic": {"torque_Nm": 17.0, "speed_rad_s": 0.0},
     "cautious": {"torque_Nm": 18.0, "speed_rad_s": 0.0}},
    {"speed": "zero", "bound": "lower", "mode": "at rest",
     "optimistic": {"torque_Nm": 19.0, "speed_rad_s": 0.0},
     "cautious": {"torque_Nm": 0.0, "speed_rad_s": 0.0}}])"));
}

TEST(SimulatorFileJson, HoldsATableInItsThreeBlocks) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kConservative);
  const auto json = nlohmann::json::parse(
      simulator_file_json(subject, file_of(exporters::raisim1, {1, 2, -3, -4, 5, 6})).dump());
  EXPECT_EQ(json["fit"], "conservative");
  EXPECT_EQ(json["parameters"], nlohmann::json::parse(R"({"speed_rad_s": [1.0, 2.0],
    "torque_min_Nm": [-3.0, -4.0], "torque_max_Nm": [5.0, 6.0]})"));
}

// Where no inertia is stated, no file holds one: a 0 would be a claim.
TEST(SimulatorFile, LeavesOutAnArmatureThatNobodyStated) {
  Actuator actuator = knee();
  actuator.motor.rotor_inertia_kg_m2 = 0.0;
  const Example example(actuator);
  const Subject subject = example.subject(LawFit::kConservative);
  for (const Exporter* exporter : exporter_library()) {
    const SimulatorFile file = simulator_file(subject, *exporter, {});
    EXPECT_NE(file.text.find("Armature: left out"), std::string::npos) << exporter->name;
    for (const char* claim : {"armature=", "armature = ", "joint_armature["}) {
      EXPECT_EQ(file.text.find(claim), std::string::npos) << exporter->name;
    }
    EXPECT_TRUE(simulator_file_json(subject, file)["armature_kg_m2"].is_null());
  }
}

TEST(ErrorLines, HoldEveryFigureInItsRow) {
  EXPECT_EQ(error_lines(errors()),
            (std::vector<std::string>{
                "Worst torque error of the simulator with this file, |speed| up to 12.5 rad/s:",
                "             bound               too optimistic                 too cautious",
                "speed > 0, driving              1 Nm at 2 rad/s              3 Nm at 4 rad/s",
                "speed > 0, braking              5 Nm at 6 rad/s              7 Nm at 8 rad/s",
                "speed < 0, braking            9 Nm at -10 rad/s           11 Nm at -12 rad/s",
                "speed < 0, driving                         none           15 Nm at -16 rad/s",
                "    at rest, upper             17 Nm at 0 rad/s             18 Nm at 0 rad/s",
                "    at rest, lower             19 Nm at 0 rad/s                         none",
                "12.5 % of the torque-speed area that the simulator allows lies outside the region",
                "It is so."}));
}

TEST(Text, NamesAreOfLettersDigitsAndUnderscores) {
  EXPECT_EQ(identifier("Knee-9 z"), "Knee_9_z");
  EXPECT_EQ(identifier("azAZ09"), "azAZ09");
  EXPECT_EQ(identifier("@[`{/:"), "______");  // the neighbours of a, z, A, Z, 0 and 9
  EXPECT_EQ(identifier("0 mm"), "a_0_mm");
  EXPECT_EQ(identifier("9"), "a_9");
  EXPECT_EQ(identifier(""), "a_");
}

TEST(Text, CommentsHoldAnyLine) {
  EXPECT_EQ(line_comment({"one", "two\nthree\x7f", "end\\"}, "// "),
            "// one\n// two three \n// end\\.\n");
  EXPECT_EQ(xml_comment({"a--b", "c"}), "<!--\n  a- -b\n  c\n-->\n");
  EXPECT_EQ(xml_quoted("a<b>\"&\tc"), "\"a&lt;b&gt;&quot;&amp; c\"");
}

}  // namespace
}  // namespace torquewright::actuator
