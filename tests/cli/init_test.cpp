// SPDX-License-Identifier: Apache-2.0
// Documents to start from and pages of keys. Oracle: the commands that such documents are for,
// which must take them as they are, and the pages in docs/documents as they were committed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/documents/schema.hpp"
#include "tests/cli/shell_words.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// Every kind whose schema says what is usually stated of it.
std::vector<std::string> started_kinds() {
  std::vector<std::string> kinds;
  for (const std::string& kind : io::document_kinds()) {
    if (io::schema_of(kind).contains("usually_stated")) kinds.push_back(kind);
  }
  return kinds;
}
const std::vector<std::string> kStarted = started_kinds();

/// A folder with every document to start from, KIND.json: the short ones, or with every key.
struct Started : Workplace {
  explicit Started(const Words& more = {}) {
    for (const std::string& kind : kStarted) {
      Words command{"init", kind, "-o", kind + ".json"};
      command.insert(command.end(), more.begin(), more.end());
      EXPECT_EQ(run(command).exit_code, 0) << kind;
    }
  }
};

/// The paths of all values that are no objects or lists.
void collect_leaves(const json& value, const std::string& path,
                    std::map<std::string, json>& leaves) {
  if (!value.is_structured()) {
    leaves[path] = value;
    return;
  }
  for (const auto& [key, child] : value.items()) collect_leaves(child, path + "/" + key, leaves);
}

std::map<std::string, json> leaves_of(json document) {
  document.erase("assumed");
  std::map<std::string, json> leaves;
  collect_leaves(document, "", leaves);
  return leaves;
}

void expect_taken(const Workplace& place, const Words& command) {
  const Outcome outcome = place.run(command);
  EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(command) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

/// A motion in the units that the columns to start from state: 1 s of a slow swing.
std::string swing() {
  std::string csv = "t,q_knee,qd_knee,tau_knee\n";
  for (int ms = 0; ms <= 1000; ms += 10) {
    const double angle = 2.0 * std::numbers::pi * ms / 1000.0;
    const double speed_deg_s = 20.0 * 2.0 * std::numbers::pi * std::cos(angle);
    csv += std::to_string(ms) + "," + std::to_string(20.0 * std::sin(angle)) + "," +
           std::to_string(speed_deg_s / 6.0) + ",5\n";
  }
  return csv;
}

/// Semicolons, decimal commas, a speed in rpm that says so nowhere; 6 s at 200 Hz.
std::string semicolon_log_of_a_flywheel() {
  std::string csv = "t_ms;q_rad;speed;i_A;remark\n";
  for (int i = 0; i < 1200; ++i) {
    const double t_s = 0.005 * i;
    const double speed_rad_s = 6.0 * std::sin(4.0 * t_s);
    const double torque_Nm = 0.02 * 24.0 * std::cos(4.0 * t_s) + (speed_rad_s > 0.0 ? 0.3 : -0.3);
    std::string row = std::to_string(1e3 * t_s) + ";" + std::to_string(-1.5 * std::cos(4.0 * t_s)) +
                      ";" + std::to_string(speed_rad_s * 30.0 / std::numbers::pi) + ";" +
                      std::to_string(torque_Nm) + ";0\n";
    std::replace(row.begin(), row.end(), '.', ',');
    csv += row;
  }
  return csv;
}

// Which document names the file that is not there, and under which key.
TEST(Init, OfARobotWithoutItsActuatorSaysWhoNamesIt) {
  const Workplace place;
  ASSERT_EQ(place.run({"init", "robot", "-o", "r.json"}).exit_code, 0);
  const json robot = json::parse(place.text("r.json"));
  const Outcome outcome = place.run({"robot", "export", "r.json", "--format", "urdf"});
  EXPECT_EQ(outcome.exit_code, 2);
  std::string expected;
  for (std::size_t i = 0; i < robot["mechanisms"].size(); ++i) {
    for (std::size_t j = 0; j < robot["mechanisms"][i]["actuators"].size(); ++j) {
      expected += "r.json#/mechanisms/" + std::to_string(i) + "/actuators/" + std::to_string(j) +
                  ": \"actuator.json\": no such file, seen from this document\n";
    }
  }
  EXPECT_EQ(outcome.err, expected);
}

TEST(Init, OfAnActuatorWithoutItsGearboxSaysWhoNamesIt) {
  const Workplace place;
  json actuator = json::parse(text_of(in_repository("specs/actuator/d151_knee.json")));
  actuator.erase("assumed");  // efficiencies, which a file of teeth replaces
  actuator["gearbox"] = {{"file", "gone.json"}, {"friction_coefficient", 0.05}};
  place.write("a.json", actuator.dump());
  const Outcome outcome = place.run({"actuator", "mor", "a.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "a.json#/gearbox/file: \"gone.json\": no such file, seen from this document\n");
}

class EveryStart : public testing::TestWithParam<Words> {};

TEST_P(EveryStart, IsTakenByItsCommands) {
  const Started place(GetParam());
  place.write("swing.csv", swing());
  expect_taken(place, {"gearbox", "optimize", "gearbox_problem.json"});
  expect_taken(place, {"gearbox", "strength", "gear_strength.json", "--torque", "2"});
  expect_taken(place, {"actuator", "lint", "actuator.json"});
  expect_taken(place, {"actuator", "mor", "actuator.json"});
  expect_taken(place, {"robot", "export", "robot.json", "--format", "mjcf"});
  expect_taken(place, {"actuator", "check", "swing.csv", "--columns", "trajectory_columns.json",
                       "--joint", "knee=actuator.json"});
}

INSTANTIATE_TEST_SUITE_P(Init, EveryStart, testing::Values(Words{}, Words{"--all-keys"}),
                         [](const auto& each) { return each.param.empty() ? "Short" : "AllKeys"; });

// The short document is part of the whole one: every value of it stands there, under the same
// pointer, and what it calls assumed is in it. Two kinds of many keys lose more than half of
// theirs.
TEST(Init, ShortDocumentsArePartsOfWholeOnes) {
  const Started few, all(Words{"--all-keys"});
  EXPECT_GE(kStarted.size(), 12U);
  for (const std::string& kind : kStarted) {
    const json part = json::parse(few.text(kind + ".json")),
               whole = json::parse(all.text(kind + ".json"));
    EXPECT_TRUE(io::conforms(part, kind)) << kind;
    EXPECT_TRUE(io::conforms(whole, kind)) << kind;
    const auto leaves = leaves_of(part), whole_leaves = leaves_of(whole);
    for (const auto& [path, value] : leaves) {
      ASSERT_TRUE(whole_leaves.count(path)) << kind << path;
      EXPECT_EQ(whole_leaves.at(path), value) << kind << path;
    }
    for (const json& pointer : part.value("assumed", json::array())) {
      EXPECT_TRUE(part.contains(json::json_pointer(pointer.get<std::string>()))) << kind << pointer;
    }
    const bool is_long = kind == "actuator" || kind == "randomisation";
    EXPECT_LT(leaves.size(), is_long ? whole_leaves.size() / 2 : whole_leaves.size() + 1) << kind;
  }
}

// Of what stands in the document every key is explained, of all keys only where they are asked for.
// Oracle: the keys of the page docs/documents/actuator.md.
TEST(Init, ExplainsTheKeysOfTheDocument) {
  const Workplace place;
  const std::string few = place.run({"init", "actuator", "-o", "few.json"}).out;
  const std::string all = place.run({"init", "actuator", "--all-keys", "-o", "all.json"}).out;
  EXPECT_NE(few.find("\n/motor/resistance_ohm  ("), std::string::npos) << few;
  EXPECT_EQ(few.find("\n/battery"), std::string::npos) << few;
  EXPECT_NE(all.find("\n/battery/series_cells  ("), std::string::npos) << all;
  const auto rows = [](const std::string& text, const std::string& start) {
    std::size_t count = 0;
    for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1))
      ++count;
    return count;
  };
  const std::size_t keys = rows(text_of(in_repository("docs/documents/actuator.md")), "\n| `/") +
                           rows(text_of(in_repository("docs/documents/actuator.md")), "\n| **`/");
  EXPECT_EQ(rows(all, "\n/"), keys);
  const std::string more = std::to_string(keys - rows(few, "\n/")) + " more keys may stand there";
  EXPECT_NE(few.find(more), std::string::npos) << few;
}

// What stands there is what is assumed where it does not stand.
TEST(Init, WritesAllThatASynthesisAssumes) {
  const Workplace place;
  ASSERT_EQ(place.run({"init", "gearbox_problem", "--synthesis", "--all-keys", "-o", "all.json"})
                .exit_code,
            0);
  ASSERT_EQ(place.run({"init", "gearbox_problem", "--synthesis", "-o", "short.json"}).exit_code, 0);
  const json all = json::parse(place.text("all.json"));
  EXPECT_EQ(all["synthesis"]["max_face_width_over_module"], 16);
  json few = all;
  for (const json& pointer : all["assumed"]) {
    const json::json_pointer key(pointer.get<std::string>());
    ASSERT_TRUE(all.contains(key)) << pointer;
    few[key.parent_pointer()].erase(key.back());
  }
  few.erase("assumed");
  few.erase("materials");
  EXPECT_EQ(few.size(), 7U) << few;
  EXPECT_EQ(json::parse(place.text("short.json"))["load"], all["load"]);
  place.write("few.json", few.dump());
  json problems[2];
  for (const int i : {0, 1}) {
    const Outcome outcome = place.run(
        {"gearbox", "optimize", i == 0 ? "all.json" : "few.json", "--max-nodes", "1", "--json"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    problems[i] = json::parse(outcome.out)["problem"];
  }
  EXPECT_EQ(problems[0], problems[1]);
  EXPECT_EQ(place.run({"init", "actuator", "--synthesis"}).exit_code, 2);
}

TEST(Init, WritesAGearboxThatAnActuatorTakes) {
  const Started place;
  json actuator = json::parse(place.text("actuator.json"));
  actuator["gearbox"] = {{"file", "gearbox.json"}, {"friction_coefficient", 0.08}};
  place.write("geared.json", actuator.dump());
  expect_taken(place, {"actuator", "mor", "geared.json"});
}

TEST(Init, WritesAJacobianThatACheckTakes) {
  const Started place;
  std::string csv = "time_s";
  for (const char* joint : {"ankle_pitch", "ankle_roll"}) {
    for (const char* quantity : {"_position_rad", "_velocity_rad_s", "_torque_Nm"}) {
      csv += std::string(",") + joint + quantity;
    }
  }
  csv += "\n0,0,0.1,3,0,0,0\n0.1,0.01,0.1,3,0,0,0\n0.2,0.02,0.1,3,0,0,0\n";
  place.write("ankle.csv", csv);
  expect_taken(place, {"actuator", "check", "ankle.csv", "--jacobian", "jacobian.json", "--joint",
                       "ankle_inner=actuator.json", "--joint", "ankle_outer=actuator.json"});
}

TEST(Init, WritesWhatTrialsDraw) {
  const Started place;
  const Outcome outcome =
      place.run({"hopper", "replay", in_repository("specs/robot/hopper.json").string(),
                 in_repository("specs/trajectory/hopper_squat.csv").string(), "--trials", "2",
                 "--randomise", "randomisation.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST(Init, PrintsTheDocumentOrWhatItsKeysMean) {
  const Outcome document = run({"init", "rig"});
  EXPECT_EQ(json::parse(document.out)["kind"], "rig");
  const Outcome meaning = run({"init", "rig", "--explain"});
  EXPECT_NE(meaning.out.find("/load/length_m  (a number from 0.0001 to 100; in m)\n"
                             "    Pendulum: from its axis to its centre of mass.\n"),
            std::string::npos)
      << meaning.out;
  const Workplace place;
  EXPECT_NE(meaning.out.find("torquewright init rig --all-keys --explain\n"), std::string::npos);
  const Outcome both = place.run({"init", "rig", "-o", "a rig.json"});
  EXPECT_EQ(place.text("a rig.json"), document.out);
  EXPECT_EQ(
      both.out,
      meaning.out + "\nnext: torquewright identify LOG --rig 'a rig.json' --actuator ACTUATOR\n");
}

// Oracle: /bin/sh takes the line apart into the words that were meant.
TEST(Init, NextLineIsWhatAShellTakes) {
  const Workplace place;
  for (const std::string kind :
       {"actuator", "gear_strength", "gearbox_problem", "jacobian", "policy", "randomisation",
        "rig", "training_task", "trajectory_columns"}) {
    const std::string name = kind + " " + kAwkwardName;
    const Outcome started = place.run({"init", kind, "-o", name});
    ASSERT_EQ(started.exit_code, 0) << started.err;
    const auto words = suggested_words(started.out, "next: torquewright");
    EXPECT_EQ(std::count(words.begin(), words.end(), name), 1) << started.out;
  }
  const Outcome robot = place.run({"init", "robot", "-o", kAwkwardName});
  const auto words = suggested_words(robot.out, "; then robot export");
  EXPECT_EQ(words, (std::vector<std::string>{kAwkwardName, "--format", "mjcf"})) << robot.out;
  // Named in a document, not by a shell: not repeated.
  const Outcome gearbox = place.run({"init", "gearbox", "-o", "gears " + kAwkwardName});
  EXPECT_TRUE(gearbox.out.ends_with(
      "\nnext: torquewright actuator mor ACTUATOR, whose \"gearbox\" names this file as its "
      "\"file\"\n"))
      << gearbox.out;
}

// A log as a spreadsheet writes it leads by three commands to an answer. Oracle: a free flywheel of
// 0.02 kg m^2 by closed form, with 0.3 Nm of friction that no document states.
TEST(Init, DraftsARigFromALogThatIdentifyTakes) {
  const Workplace place;
  place.write("log.csv", semicolon_log_of_a_flywheel());
  const Outcome drafted = place.run({"init", "rig", "--from", "log.csv", "-o", "rig.json"});
  ASSERT_EQ(drafted.exit_code, 0) << drafted.err;
  EXPECT_NE(drafted.out.find("speed"), std::string::npos) << drafted.out;
  EXPECT_NE(drafted.out.find("next: torquewright identify log.csv --rig rig.json"),
            std::string::npos)
      << drafted.out;
  json rig = json::parse(place.text("rig.json"));
  EXPECT_EQ(rig["columns"]["speed"],
            (json{{"quantity", "output_velocity_rad_s"}, {"unit", "rpm"}}));
  EXPECT_EQ(rig["assumed"], json::array({"/columns/speed"}));
  EXPECT_EQ(rig["ignore"], json::array({"remark"}));
  // What the log cannot say is refused until it is stated, and nothing else is.
  const Words identify = {"identify", "log.csv",    "--rig",
                          "rig.json", "--actuator", in_specs("log/bench_actuator.json")};
  const Outcome open = place.run(identify);
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_NE(open.err.find("/load: missing"), std::string::npos) << open.err;
  rig["load"] = {{"type", "free"}, {"inertia_kg_m2", 0.02}};
  place.write("rig.json", rig.dump());
  const Outcome found = place.run(identify);
  EXPECT_LE(found.exit_code, 1) << found.err;
  EXPECT_EQ(found.err.find("rig.json"), std::string::npos) << found.err;
}

// The example log, of which the runs' column is called otherwise. Oracle: its own first column,
// four names of 1500 rows each, which identify needs since each run's time begins at 0.
TEST(Init, DraftsTheRigOfTheExampleWithoutAnEditor) {
  const Workplace place;
  const std::string log = in_specs("log/bench.csv");
  ASSERT_EQ(place.run({"init", "rig", "--from", log, "-o", "rig.json"}).exit_code, 0);
  EXPECT_EQ(json::parse(place.text("rig.json"))["columns"]["Test"], "run");
  const Outcome found = place.run(
      {"identify", log, "--rig", "rig.json", "--actuator", in_specs("log/bench_actuator.json")});
  EXPECT_LE(found.exit_code, 1) << found.err;
  EXPECT_NE(found.out.find("held out: T3, T4"), std::string::npos) << found.out;
}

TEST(Init, FromWhatIsNoLogIsRefused) {
  const Workplace place;
  place.write("log.csv", "apples,pears\n1,2\n2,1\n");
  const Outcome unknown = place.run({"init", "rig", "--from", "log.csv", "-o", "rig.json"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("none of its columns"), std::string::npos) << unknown.err;
  EXPECT_FALSE(place.has("rig.json"));
  EXPECT_EQ(place.run({"init", "rig", "--from", "gone.csv"}).exit_code, 2);
  const Outcome robot = place.run({"init", "robot", "--from", "log.csv"});
  EXPECT_EQ(robot.exit_code, 2);
  EXPECT_NE(robot.err.find("--from: is of an actuator"), std::string::npos) << robot.err;
}

TEST(Init, WritesOverNothingAndStartsNoReport) {
  const Workplace place;
  place.write("rig.json", "{}");
  const Outcome over = place.run({"init", "rig", "-o", "rig.json"});
  EXPECT_EQ(over.exit_code, 2);
  EXPECT_EQ(over.err, "rig.json: is there already; init writes over no document\n");
  EXPECT_EQ(place.text("rig.json"), "{}");
  const Outcome report = place.run({"init", "lint_report"});
  EXPECT_EQ(report.exit_code, 2);
  EXPECT_EQ(report.err,
            "init: a lint_report is written by the program; documents to start from are actuator, "
            "controller, "
            "gear_strength, gearbox, gearbox_problem, jacobian, policy, randomisation, rig, robot, "
            "training_task, trajectory_columns\n");
}

TEST(Schema, IsTheFileWithOtherKindsInIt) {
  for (const std::string& kind : io::document_kinds()) {
    json file = json::parse(text_of(in_repository("specs/schema/" + kind + ".json")));
    if (kind == "gearbox_result") {
      const json problem = json::parse(text_of(in_repository("specs/schema/gearbox_problem.json")));
      const json meaning = file["properties"]["problem"]["description"];
      file["properties"]["problem"] = problem;
      file["properties"]["problem"]["description"] = meaning;
    }
    EXPECT_EQ(json::parse(run({"schema", kind}).out), file) << kind;
  }
}

TEST(Schema, IsAcceptedByTheDocumentsThatNameIt) {
  const Started place;
  json actuator = json::parse(place.text("actuator.json"));
  actuator["$schema"] = "actuator.schema.json";
  place.write("named.json", actuator.dump());
  expect_taken(place, {"actuator", "mor", "named.json"});
}

TEST(DocumentPages, AreAsTheProgramWritesThem) {
  for (const std::string& kind : io::document_kinds()) {
    EXPECT_EQ(text_of(in_repository("docs/documents/" + kind + ".md")),
              run({"schema", kind, "--markdown"}).out)
        << "torquewright schema " << kind << " --markdown -o docs/documents/" << kind << ".md";
  }
}

}  // namespace
}  // namespace torquewright::cli_test
