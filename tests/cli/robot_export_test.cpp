// SPDX-License-Identifier: Apache-2.0
// robot export: what a format takes and refuses. Oracle: the documents, by hand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

const std::string& hopper() {
  static const std::string file = in_specs("robot/hopper.json");
  return file;
}

Outcome exported(const Workplace& place, const std::vector<std::string>& more) {
  std::vector<std::string> words{"robot", "export", hopper()};
  words.insert(words.end(), more.begin(), more.end());
  return place.run(words);
}

TEST(RobotExport, WritesDrivesForEverySimulator) {
  Workplace place;
  for (const char* format : {"urdf", "gazebo", "drake", "genesis", "pybullet", "isaac-gym"}) {
    const Outcome outcome = exported(place, {"--format", format, "--actuators"});
    EXPECT_EQ(outcome.exit_code, 0) << format << outcome.err;
    EXPECT_NE(outcome.out.find("ankle_pitch"), std::string::npos) << format;
  }
}

// By hand: 20 0.32 50 = 320 Nm at the knee; without --actuators nobody states an effort.
TEST(RobotExport, WritesEffortsOfDrivesIntoUrdf) {
  Workplace place;
  const Outcome with = exported(place, {"--format", "urdf", "--actuators"});
  const Outcome without = exported(place, {"--format", "urdf"});
  const std::size_t joint = with.out.find("<joint name=\"knee\"");
  ASSERT_NE(joint, std::string::npos);
  EXPECT_NE(with.out.find("effort=\"3", joint), std::string::npos);
  for (const Outcome* outcome : {&with, &without}) {
    EXPECT_EQ(outcome->out.find("effort=\"0\""), std::string::npos);
    EXPECT_EQ(outcome->out.find("velocity=\"0\""), std::string::npos);
  }
}

TEST(RobotExport, RefusesWhatAFormatCannotHold) {
  struct Refused {
    std::vector<std::string> words;
    std::string says;
  };
  Workplace place;
  const std::string randomisation = in_specs("randomisation/hopper.json");
  for (const Refused& refused : {
           Refused{{"--format", "genesis"},
                   "genesis holds drives and nothing else: say "
                   "--actuators"},
           Refused{{"--format", "gazebo", "--ground"}, "are for mjcf and playground"},
           Refused{{"--format", "urdf", "--actuators", "--servos"}, "are for mjcf and playground"},
           Refused{{"--format", "mjcf", "--servos"}, "--actuators"},
           Refused{{"--format", "drake", "--actuators", "--friction", "joint"},
                   "joints of drake have no dry friction"},
           Refused{{"--format", "gazebo", "--randomise", randomisation}, "has no form for it"},
           Refused{
               {"--format", "playground", "--actuators", "--servos", "--randomise", randomisation},
               "/bus_voltage_factor"},
       }) {
    std::vector<std::string> words = refused.words;
    words.insert(words.end(), {"-o", "written"});
    const Outcome outcome = exported(place, words);
    EXPECT_EQ(outcome.exit_code, 2) << refused.says;
    EXPECT_NE(outcome.err.find(refused.says), std::string::npos) << outcome.err;
    EXPECT_FALSE(place.has("written")) << refused.says;
  }
  const Outcome driveless = place.run({"robot", "export", in_specs("robot/rabbit.json"), "--format",
                                       "playground", "--randomise", "tolerances"});
  EXPECT_EQ(driveless.exit_code, 2);
  EXPECT_NE(driveless.err.find("tolerances are of drives"), std::string::npos) << driveless.err;
  const Outcome bare = place.run(
      {"robot", "export", in_specs("robot/rabbit.json"), "--format", "gazebo", "--actuators"});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_NE(bare.err.find("there are no drives"), std::string::npos) << bare.err;
}

// The catalogue's 10 % of both drives, whose torque constants state no tolerance.
TEST(RobotExport, RandomisesByTheDrivesOwnTolerances) {
  Workplace place;
  const Outcome outcome =
      exported(place, {"--format", "newton", "--actuators", "--randomise", "tolerances"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line :
       {"# Randomisation: tolerances of the drives' own documents (docs/lint.md).",
        "# Assumed: knee: motor strength within 10 %, a catalogue's, for the document states none",
        "    (\"ankle_roll\", 0.9, 1.1),"}) {
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace torquewright::cli_test
