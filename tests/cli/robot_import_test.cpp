// SPDX-License-Identifier: Apache-2.0
// Robots with closed loops in and out.
#include <gtest/gtest.h>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

class LoopedFile : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome exported =
        place_.run({"robot", "export", in_repository("specs/robot/hopper.json").string(),
                    "--format", "mjcf", "--closed-loops", "--actuators", "-o", "looped.xml"});
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
  }

  Outcome import(const Words& more) const {
    Words words{"robot", "import", "looped.xml", "-o", "robot.json"};
    words.insert(words.end(), more.begin(), more.end());
    return place_.run(words);
  }

  static Words actuators() {
    const std::string knee = in_repository("specs/actuator/d151_knee.json").string();
    const std::string ankle = in_repository("specs/actuator/d110a_ankle.json").string();
    return {"--actuator", "knee=" + knee,         "--actuator",      "ankle_left=" + ankle,
            "--actuator", "ankle_right=" + ankle, "--massless-links"};
  }

  Workplace place_;
};

TEST_F(LoopedFile, IsARobotWithMechanismsAgain) {
  const Outcome imported = import(actuators());
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_NE(imported.out.find("is read as a parallel_ankle"), std::string::npos) << imported.out;
  EXPECT_NE(imported.out.find("cranks and rods are left out"), std::string::npos) << imported.out;
  const Outcome again = place_.run(
      {"robot", "export", "robot.json", "--format", "mjcf", "--closed-loops", "--actuators"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST_F(LoopedFile, NeedsItsActuators) {
  const Outcome imported = import({});
  EXPECT_EQ(imported.exit_code, 2);
  EXPECT_NE(imported.err.find("--actuator knee=FILE"), std::string::npos) << imported.err;
}

TEST_F(LoopedFile, HasNoOtherDrives) {
  Words words = actuators();
  words.insert(words.end(), {"--actuator", "hip=x.json"});
  const Outcome imported = import(words);
  EXPECT_EQ(imported.exit_code, 2);
  EXPECT_NE(imported.err.find("no linkage of the file has a drive \"hip\""), std::string::npos)
      << imported.err;
}

}  // namespace
}  // namespace torquewright::cli_test
