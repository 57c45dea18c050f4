// SPDX-License-Identifier: Apache-2.0
// What the actuator commands print as JSON is of the kind it says. Oracle: the kinds' schemas.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "io/faults/diagnosis.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

const std::vector<std::string> kActuators = {
    "cassie_hip_roll_yaw", "cassie_knee",      "cassie_toe",       "d110a_ankle",
    "d151_knee",           "mini_cheetah_hip", "mini_cheetah_knee"};

std::string spec(const std::string& name) {
  return in_repository("specs/actuator/" + name + ".json").string();
}

json expect_document(const Outcome& outcome, const std::string& kind) {
  EXPECT_EQ(outcome.err, "");
  const json document = json::parse(outcome.out, nullptr, false);
  if (document.is_discarded()) {
    ADD_FAILURE() << outcome.out;
    return {};
  }
  EXPECT_EQ(document.value("kind", ""), kind);
  for (const io::Fault& fault : io::diagnose(document, io::schema_of(kind), kind, "")) {
    ADD_FAILURE() << fault.path << ": " << fault.message;
  }
  EXPECT_TRUE(io::conforms(document, kind)) << outcome.out;
  EXPECT_EQ(document["tool"]["name"], "torquewright");
  return document;
}

TEST(ActuatorDocument, MorTableIsOfItsSchema) {
  const Workplace place;
  for (const std::string& name : kActuators) {
    SCOPED_TRACE(name);
    expect_document(place.run({"actuator", "mor", spec(name), "--json"}), "mor_table");
    // Beyond every speed: rows without torque.
    const json rows = expect_document(place.run({"actuator", "mor", spec(name), "--side", "motor",
                                                 "--json", "--at-speed", "-9999,0,9999"}),
                                      "mor_table");
    EXPECT_TRUE(rows["rows"][2]["torque_max_Nm"].is_null());
  }
}

TEST(ActuatorDocument, MorTableHoldsPlugging) {
  const Workplace place;
  std::string text = text_of(spec("d151_knee"));
  text = with(text, "\"regeneration\": true", "\"regeneration\": false");
  place.write("knee.json", text);
  const json document = expect_document(
      place.run({"actuator", "mor", "knee.json", "--json", "--at-speed", "1"}), "mor_table");
  EXPECT_TRUE(document["rows"][0].contains("plugging"));
}

TEST(ActuatorDocument, SimulatorFileIsOfItsSchema) {
  const Workplace place;
  for (const auto& format : io::schema_of("simulator_file")["properties"]["format"]["enum"]) {
    for (const char* fit : {"conservative", "best"}) {
      SCOPED_TRACE(format.get<std::string>() + " " + fit);
      expect_document(place.run({"actuator", "mor", spec("d110a_ankle"), "--format",
                                 format.get<std::string>(), "--fit", fit, "--json"}),
                      "simulator_file");
    }
  }
}

// Linux allows any bytes in a file's name, JSON only UTF-8 (RFC 8259, 8.1): U+FFFD stands for the
// others.
TEST(ActuatorDocument, NamesAFileThatIsNoText) {
  const Workplace place;
  place.write("knee\xff.json", text_of(spec("d151_knee")));
  const std::vector<std::pair<std::vector<std::string>, std::string>> commands{
      {{"lint", "knee\xff.json"}, "lint_report"},
      {{"mor", "knee\xff.json"}, "mor_table"},
      {{"mor", "knee\xff.json", "--format", "mujoco"}, "simulator_file"},
      {{"mor", "knee\xff.json", "--need", "200@10"}, "mor_need"}};
  for (const auto& [arguments, kind] : commands) {
    SCOPED_TRACE(kind);
    std::vector<std::string> words{"actuator"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    words.emplace_back("--json");
    const Outcome outcome = place.run(words);
    EXPECT_LE(outcome.exit_code, 1);
    EXPECT_EQ(expect_document(outcome, kind)["inputs"][0]["path"], "knee\xEF\xBF\xBD.json");
  }
}

TEST(ActuatorDocument, AnswersToNeedsAndRatiosAreOfTheirSchemas) {
  const Workplace place;
  for (const char* need : {"100@5", "200@10", "1e5@1", "1@9999"}) {
    SCOPED_TRACE(need);
    expect_document(place.run({"actuator", "mor", spec("d151_knee"), "--need", need, "--json"}),
                    "mor_need");
    expect_document(place.run({"actuator", "mor", spec("d151_knee"), "--need", need, "--ratio",
                               "4:40", "--json"}),
                    "mor_ratios");
  }
  expect_document(place.run({"actuator", "mor", spec("d151_knee"), "--ratio", "4:40", "--json"}),
                  "mor_ratios");
}

TEST(ActuatorDocument, LintReportIsOfItsSchema) {
  const Workplace place;
  std::vector<std::string> all{"actuator", "lint", "--json"};
  for (const std::string& name : kActuators) all.push_back(spec(name));
  expect_document(place.run(all), "lint_report");
}

// Passing, failing, impossible and undecided motions, with and without torque and heat.
TEST(ActuatorDocument, CheckReportIsOfItsSchema) {
  const Workplace place;
  std::string hot = text_of(spec("d151_knee"));
  const std::size_t end = hot.rfind('}');
  hot.insert(end, R"(, "thermal": {"winding_to_case_K_W": 1.0, "case_to_ambient_K_W": 1.0,
    "winding_J_K": 50, "case_J_K": 500, "winding_limit_K": 300})");
  place.write("hot.json", hot);
  const auto run = [&](const std::string& rows, const std::string& actuator,
                       const std::string& verdict) {
    SCOPED_TRACE(rows);
    place.write("m.csv", rows);
    const json document =
        expect_document(place.run({"actuator", "check", "m.csv", "--joint", "knee=" + actuator,
                                   "--json", "--repeat", "3"}),
                        "check_report");
    EXPECT_EQ(document["verdict"], verdict);
  };
  const std::string header = "time_s,knee_velocity_rad_s,knee_torque_Nm\n";
  run(header + "0,5,100\n1,5,110\n", spec("d151_knee"), "pass");
  run(header + "0,5,100\n1,5,200\n", "hot.json", "fail");  // 200 Nm burn 0.27 kW: 5 K a second
  run(header + "0,5,100\n1,5,900\n", spec("d151_knee"), "fail");
  run(header + "0,5,100\n1,50,1\n", spec("d151_knee"), "fail");
  run("time_s,knee_velocity_rad_s\n0,5\n1,5\n", spec("d151_knee"), "undecided");
  run("time_s,knee_velocity_rad_s\n0,5\n1,50\n", spec("d151_knee"), "fail");
  run("time_s,knee_position_rad,knee_torque_Nm\n0,0,1\n1,1,1\n2,2,1\n", "hot.json", "pass");
}

}  // namespace
}  // namespace torquewright::cli_test
