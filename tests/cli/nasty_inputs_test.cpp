// SPDX-License-Identifier: Apache-2.0
// Inputs that somebody will bring, to every command that takes such a file. Rules: it ends with 0
// to 3, says why where it ends with 2, writes no nan or inf, and leaves nothing behind.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/cli/nasty.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

TEST(NastyInputs, ATableWithoutAName) {
  const std::string robot = in_repository("specs/robot/hopper.json").string();
  expect_civil(Workplace(), {"hopper", "check", robot, "", "--report", "page.html"}, "no name", 0);
}

std::string file(const char* name) { return in_repository(name).string(); }

/// Tables of each kind that a command reads, by the names under which they are spoilt.
const std::vector<std::pair<const char*, const char*>> kTables{
    {"knee.csv", "specs/trajectory/knee_extension.csv"},
    {"lift.csv", "specs/trajectory/bench_lift.csv"},
    {"flip.csv", "specs/trajectory/hopper_flip.csv"},
    {"play.csv", "specs/excitation/knee_sweep.csv"},
    {"log.csv", "specs/log/bench_as_built.csv"}};

std::vector<Words> readers_of_tables() {
  const std::string knee = file("specs/actuator/d151_knee.json");
  const std::string bench = file("specs/log/bench_actuator.json");
  const std::string robot = file("specs/robot/hopper.json");
  return {{"actuator", "check", "knee.csv", "--joint", "knee=" + knee},
          // A motion that heats, so often that every heat comes to its end.
          {"actuator", "check", "lift.csv", "--joint", "knee=" + bench, "--repeat", "1000000000",
           "--json"},
          {"actuator", "check", "knee.csv", "--joint", "knee=" + knee, "--plot", "c.svg"},
          {"hopper", "check", robot, "flip.csv"},
          {"hopper", "check", robot, "flip.csv", "--plot", "a.svg", "--plot-loads", "b.svg"},
          {"identify", "simulate", knee, "--rig", file("specs/rig/knee_sweep.json"), "--excitation",
           "play.csv"},
          {"identify", "log.csv", "--rig", file("specs/log/bench_rig.json"), "--actuator", bench}};
}

TEST(NastyInputs, TablesOfMotions) {
  Workplace place;
  for (const char* picture : {"a.svg", "b.svg", "c.svg"}) place.write(picture, "");
  const std::size_t files = 3 + kTables.size();
  for (const auto& [name, table] : kTables) place.write(name, text_of(in_repository(table)));
  for (const Words& command : readers_of_tables()) expect_sound(place, command, files);
  for (const Nasty& nasty : nasty_tables()) {
    for (const auto& [name, table] : kTables) {
      place.write(name, nasty.spoil(text_of(in_repository(table))));
    }
    for (const Words& command : readers_of_tables()) {
      expect_judged(place, command, std::string(nasty.what) + ", " + command[1], files,
                    nasty.is_refused);
    }
  }
}

struct DocumentReader {
  const char* name;      ///< Under which it is spoilt.
  const char* document;  ///< Which is good.
  Words command;
};

std::vector<DocumentReader> readers_of_documents() {
  const std::string motion = file("specs/trajectory/knee_extension.csv");
  const char* ankle = "specs/actuator/d110a_ankle.json";
  const char* problem = "specs/gearbox/d110a_ankle.json";
  const char* rabbit = "specs/robot/rabbit.json";
  return {
      {"actuator.json", ankle, {"actuator", "mor", "actuator.json"}},
      {"actuator.json", ankle, {"actuator", "lint", "actuator.json"}},
      {"actuator.json", ankle, {"actuator", "check", motion, "--joint", "knee=actuator.json"}},
      {"problem.json", problem, {"gearbox", "optimize", "problem.json"}},
      {"problem.json",
       problem,
       {"gearbox", "evaluate", "problem.json", "--teeth", "18,54", "--planet-count", "3"}},
      {"result.json", "specs/gearbox/d151_knee_result.json", {"gearbox", "verify", "result.json"}},
      {"strength.json",
       "specs/gearbox/d110a_strength.json",
       {"gearbox", "strength", "strength.json", "--torque", "21"}},
      {"robot.json", rabbit, {"robot", "export", "robot.json", "--format", "mjcf"}},
      {"robot.urdf", "specs/robot/rabbit.urdf", {"robot", "import", "robot.urdf"}},
      {"robot.json",
       rabbit,
       {"hopper", "check", "robot.json", file("tests/fuzz/corpus/rabbit_leap.csv")}},
      {"rig.json",
       "specs/rig/knee_sweep.json",
       {"identify", "simulate", file("specs/actuator/d151_knee.json"), "--rig", "rig.json",
        "--excitation", file("specs/excitation/knee_sweep.csv")}}};
}

/// What is wrong with a result is its verdict: rejected, exit code 1.
bool is_verified(const DocumentReader& reader) { return reader.command[1] == "verify"; }

TEST(NastyInputs, Documents) {
  for (const DocumentReader& reader : readers_of_documents()) {
    const Workplace place;
    const std::string good = text_of(in_repository(reader.document));
    place.write(reader.name, good);
    expect_sound(place, reader.command, 1);
    for (const Nasty& nasty : nasty_documents()) {
      const std::string bad = nasty.spoil(good);
      place.write(reader.name, bad);
      expect_judged(place, reader.command,
                    std::string(nasty.what) + ", " + reader.command[1] + " " + reader.name, 1,
                    bad != good && !is_verified(reader));
    }
  }
}

TEST(NastyInputs, NamesThatAreNoText) {
  const Workplace place;
  place.write(
      "kn\xE9"
      "e.json",
      text_of(in_repository("specs/actuator/d151_knee.json")));
  expect_civil(place,
               {"actuator", "mor",
                "kn\xE9"
                "e.json",
                "--json"},
               "a name in Latin-1", 1);
  expect_civil(place, {"actuator", "mor", "abs\xE9nt.json"}, "a name in Latin-1", 1);
}

// So that none of them becomes a row of a table, or a character that XML 1.0 has not (2.2 Char).
TEST(NastyInputs, NamesOfWhatIsNoLineOfText) {
  const Workplace place;
  const std::string knee = text_of(in_repository("specs/actuator/d151_knee.json"));
  for (const auto& [spelt, named] : std::vector<std::pair<std::string, std::string>>{
           {"\\n", "U+000A"}, {"\\uFFFE", "U+FFFE"}, {"\\u0001", "U+0001"}}) {
    place.write("knee.json", with(knee, "\"name\": \"", "\"name\": \"" + spelt));
    const Outcome outcome = place.run({"actuator", "mor", "knee.json", "-o", "table.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              "knee.json#/name: holds the character " + named + "; must be one line of text\n");
  }
}

// Nor does the name of a joint, which no document states.
TEST(NastyInputs, NamesOfJointsThatAreNoLineOfText) {
  const Workplace place;
  const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
  const std::string motion = text_of(in_repository("specs/trajectory/knee_extension.csv"));
  for (const auto& [name, holds] : std::vector<std::pair<std::string, std::string>>{
           {"kn\xEF\xBF\xBE", "the character U+FFFE"},
           {"kn\xE9", "the byte 0xE9, which is not UTF-8"},
           {"knee: passes\nx", "the character U+000A"}}) {
    place.write("knee.csv", motion);
    const Outcome by_joint =
        place.run({"actuator", "check", "knee.csv", "--joint", name + "=" + knee, "--column",
                   "knee_velocity_rad_s=" + name + ".velocity"});
    EXPECT_EQ(by_joint.exit_code, 2);
    EXPECT_NE(by_joint.err.find("the name holds " + holds + "; must be one line of text"),
              std::string::npos)
        << by_joint.err;
    const Outcome by_column = place.run({"actuator", "check", "knee.csv", "--joint", "knee=" + knee,
                                         "--column", "knee_velocity_rad_s=" + name + ".velocity"});
    EXPECT_EQ(by_column.exit_code, 2);
    EXPECT_NE(by_column.err.find(": holds " + holds + "; must be one line of text"),
              std::string::npos)
        << by_column.err;
  }
  place.write("knee.csv", with(motion, "knee_torque", "kn\xEF\xBF\xBE_torque"));
  const Outcome by_header = place.run({"actuator", "check", "knee.csv", "--joint", "knee=" + knee});
  EXPECT_EQ(by_header.exit_code, 2);
  EXPECT_NE(by_header.err.find("holds the character U+FFFE; must be one line of text"),
            std::string::npos)
      << by_header.err;
}

// Every reader of tables says what to do.
TEST(NastyInputs, TablesOfOtherPrograms) {
  const Workplace place;
  const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
  const std::string rig = in_repository("specs/rig/knee_sweep.json").string();
  const std::vector<std::pair<std::string, std::string>> tables{
      {"sep=|\nt,q\n0,1\n",
       "\"sep=|\" is a spreadsheet's line about separators; columns may be separated by commas, "
       "semicolons or tabs"},
      {"t,q\r0,1\r", "its lines end with carriage returns alone; convert it: tr '\\r' '\\n'"}};
  for (const auto& [table, what_to_do] : tables) {
    place.write("table.csv", table);
    for (const Words& command : std::vector<Words>{
             {"actuator", "check", "table.csv", "--joint", "knee=" + knee},
             {"hopper", "check", in_repository("specs/robot/hopper.json").string(), "table.csv"},
             {"identify", "table.csv", "--rig", rig, "--actuator", knee},
             {"identify", "simulate", knee, "--rig", rig, "--excitation", "table.csv"}}) {
      const Outcome outcome = place.run(command);
      EXPECT_EQ(outcome.exit_code, 2) << command[1];
      EXPECT_EQ(outcome.err + outcome.out, "table.csv: line 1: " + what_to_do + "\n") << command[1];
    }
  }
}

TEST(NastyInputs, FilesThatAreLinksToThemselves) {
  const Workplace place;
  fs::create_symlink("loop.xml", place.path("loop.xml"));
  place.write("robot.xml", "<mujoco><include file=\"loop.xml\"/></mujoco>");
  const Outcome outcome = place.run({"robot", "import", "robot.xml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("<include>: the file \"loop.xml\" is not there"), std::string::npos)
      << outcome.err;
}

// The parser behind it compares each attribute with all before it.
TEST(NastyInputs, ElementsOfVeryManyAttributes) {
  const Workplace place;
  std::string attributes;
  for (int i = 0; i < 300000; ++i) attributes += " a" + std::to_string(i) + "=\"1\"";
  place.write("many.urdf",
              "<robot name=\"r\">\n<!-- <a b='1'> --><link name=\"l\"" + attributes + "/></robot>");
  const Outcome outcome = place.run({"robot", "import", "many.urdf"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "many.urdf: line 2: an element with 300001 attributes; at most 1000 are read\n");
}

}  // namespace
}  // namespace torquewright::cli_test
