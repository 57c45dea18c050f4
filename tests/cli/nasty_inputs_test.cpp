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

TEST(NastyInputs, TablesOfMotions) {
  Workplace place;
  for (const char* picture : {"a.svg", "b.svg", "c.svg"}) place.write(picture, "");
  for (const Nasty& nasty : nasty_tables()) {
    place.write("knee.csv",
                nasty.spoil(text_of(in_repository("specs/trajectory/knee_extension.csv"))));
    place.write("flip.csv",
                nasty.spoil(text_of(in_repository("specs/trajectory/hopper_flip.csv"))));
    place.write("play.csv", nasty.spoil(text_of(in_repository("specs/excitation/knee_sweep.csv"))));
    const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
    const std::string robot = in_repository("specs/robot/hopper.json").string();
    const std::string rig = in_repository("specs/rig/knee_sweep.json").string();
    expect_civil(place, {"actuator", "check", "knee.csv", "--joint", "knee=" + knee}, nasty.what,
                 6);
    expect_civil(place,
                 {"actuator", "check", "knee.csv", "--joint", "knee=" + knee, "--repeat",
                  "1000000000", "--json"},
                 nasty.what, 6);
    expect_civil(place,
                 {"actuator", "check", "knee.csv", "--joint", "knee=" + knee, "--plot", "c.svg"},
                 nasty.what, 6);
    expect_civil(place, {"hopper", "check", robot, "flip.csv"}, nasty.what, 6);
    expect_civil(place,
                 {"hopper", "check", robot, "flip.csv", "--plot", "a.svg", "--plot-loads", "b.svg"},
                 nasty.what, 6);
    expect_civil(place, {"identify", "simulate", knee, "--rig", rig, "--excitation", "play.csv"},
                 nasty.what, 6);
    expect_civil(place, {"identify", "play.csv", "--rig", rig, "--actuator", knee}, nasty.what, 6);
  }
}

TEST(NastyInputs, Documents) {
  Workplace place;
  for (const Nasty& nasty : nasty_documents()) {
    const auto spoil = [&](const char* file, const char* name) {
      place.write(name, nasty.spoil(text_of(in_repository(file))));
    };
    spoil("specs/actuator/d110a_ankle.json", "actuator.json");
    spoil("specs/gearbox/d110a_ankle.json", "problem.json");
    spoil("specs/gearbox/d151_knee_result.json", "result.json");
    spoil("specs/gearbox/d110a_strength.json", "strength.json");
    spoil("specs/robot/rabbit.json", "robot.json");
    spoil("specs/robot/rabbit.urdf", "robot.urdf");
    spoil("specs/rig/knee_sweep.json", "rig.json");
    const std::string motion = in_repository("specs/trajectory/knee_extension.csv").string();
    const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
    const std::string excitation = in_repository("specs/excitation/knee_sweep.csv").string();
    for (const Words& command : std::vector<Words>{
             {"actuator", "mor", "actuator.json"},
             {"actuator", "lint", "actuator.json"},
             {"actuator", "check", motion, "--joint", "knee=actuator.json"},
             {"gearbox", "optimize", "problem.json"},
             {"gearbox", "evaluate", "problem.json", "--teeth", "18,54"},
             {"gearbox", "verify", "result.json"},
             {"gearbox", "strength", "strength.json", "--torque", "21"},
             {"robot", "export", "robot.json", "--format", "mjcf"},
             {"robot", "import", "robot.urdf"},
             {"hopper", "check", "robot.json", motion},
             {"identify", "simulate", knee, "--rig", "rig.json", "--excitation", excitation}}) {
      expect_civil(place, command, std::string(nasty.what) + ", " + command[1], 7);
    }
  }
}

TEST(NastyInputs, Numbers) {
  const Workplace place;
  const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
  const std::string motion = in_repository("specs/trajectory/knee_extension.csv").string();
  const std::string robot = in_repository("specs/robot/hopper.json").string();
  const std::string squat = in_repository("specs/trajectory/hopper_squat.csv").string();
  place.write("region.svg", "");
  for (const std::string& number : nasty_numbers()) {
    for (const char* option : {"--plot-voltage", "--plot-temperature"}) {
      expect_civil(place, {"actuator", "mor", knee, "--plot", "region.svg", option, number},
                   std::string(option) + " " + number, 1);
    }
    for (const char* option : {"--pause", "--repeat", "--state-of-charge", "--bus-voltage"}) {
      expect_civil(place, {"actuator", "check", motion, "--joint", "knee=" + knee, option, number},
                   std::string(option) + " " + number, 1);
    }
    for (const char* option : {"--load-window", "--ground-height", "--contact-time-constant"}) {
      expect_civil(place, {"hopper", "check", robot, squat, option, number},
                   std::string(option) + " " + number, 1);
    }
    for (const char* option : {"--at-speed", "--bus-voltage", "--winding-temperature",
                               "--state-of-charge", "--accuracy", "--need", "--ratio"}) {
      expect_civil(place, {"actuator", "mor", knee, option, number},
                   std::string(option) + " " + number, 1);
    }
    expect_civil(place, {"actuator", "mor", knee, "--need", "100@" + number}, number, 1);
    expect_civil(place, {"actuator", "mor", knee, "--need", number + "@1"}, number, 1);
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
           {"kn\xE9", "the byte 0xE9, which is no UTF-8"},
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
      {"t,T [\xB0"
       "C]\n0,1\n",
       "the header is no UTF-8; convert it: iconv -f latin1 -t utf-8"},
      {"sep=,\nt,q\n0,1\n",
       "\"sep=,\" is a spreadsheet's line about separators; delete it, columns are separated by "
       "commas"},
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
