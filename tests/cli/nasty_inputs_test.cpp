// SPDX-License-Identifier: Apache-2.0
// Inputs that somebody will bring, to every command that takes such a file. Rules: it ends with 0
// to 3, says why where it ends with 2, writes no nan or inf, and leaves nothing behind.
#include <gtest/gtest.h>

#include <string>
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
  for (const char* picture : {"a.svg", "b.svg"}) place.write(picture, "");
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
                 5);
    expect_civil(place,
                 {"actuator", "check", "knee.csv", "--joint", "knee=" + knee, "--repeat",
                  "1000000000", "--json"},
                 nasty.what, 5);
    expect_civil(place, {"hopper", "check", robot, "flip.csv"}, nasty.what, 5);
    expect_civil(place,
                 {"hopper", "check", robot, "flip.csv", "--plot", "a.svg", "--plot-loads", "b.svg"},
                 nasty.what, 5);
    expect_civil(place, {"identify", "simulate", knee, "--rig", rig, "--excitation", "play.csv"},
                 nasty.what, 5);
    expect_civil(place, {"identify", "play.csv", "--rig", rig, "--actuator", knee}, nasty.what, 5);
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
    const std::string motion = in_repository("specs/trajectory/knee_extension.csv").string();
    for (const Words& command :
         std::vector<Words>{{"actuator", "mor", "actuator.json"},
                            {"actuator", "lint", "actuator.json"},
                            {"actuator", "check", motion, "--joint", "knee=actuator.json"},
                            {"gearbox", "optimize", "problem.json"},
                            {"gearbox", "evaluate", "problem.json", "--teeth", "18,54"},
                            {"gearbox", "verify", "result.json"},
                            {"gearbox", "strength", "strength.json", "--torque", "21"},
                            {"robot", "export", "robot.json", "--format", "mjcf"},
                            {"robot", "import", "robot.urdf"},
                            {"hopper", "check", "robot.json", motion}}) {
      expect_civil(place, command, std::string(nasty.what) + ", " + command[1], 6);
    }
  }
}

TEST(NastyInputs, Numbers) {
  const Workplace place;
  const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
  for (const std::string& number : nasty_numbers()) {
    for (const char* option : {"--at-speed", "--bus-voltage", "--winding-temperature",
                               "--state-of-charge", "--accuracy", "--need", "--ratio"}) {
      expect_civil(place, {"actuator", "mor", knee, option, number},
                   std::string(option) + " " + number, 0);
    }
    expect_civil(place, {"actuator", "mor", knee, "--need", "100@" + number}, number, 0);
    expect_civil(place, {"actuator", "mor", knee, "--need", number + "@1"}, number, 0);
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
