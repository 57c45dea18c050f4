// SPDX-License-Identifier: Apache-2.0
// Drives on joints by pattern. Oracle: the document that comes out, which the exporter and the
// robot's own reader take, and the files that it names from where it stands.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// The file of the drive of each joint, as a document in a folder names it, made absolute.
std::map<std::string, fs::path> drives_of(const Workplace& place, const std::string& file) {
  std::map<std::string, fs::path> drives;
  const json document = json::parse(place.text(file));
  for (const json& each : document["mechanisms"]) {
    const std::string named = each["actuators"][0];
    drives[each["joints"][0]] = fs::weakly_canonical(place.path(file).parent_path() / named);
  }
  return drives;
}

TEST(RobotAttach, DrivesJointsByAPatternAndLeavesOthersTheirs) {
  const Workplace place;
  fs::create_directories(place.path("mine"));
  const Outcome attached =
      place.run({"robot", "attach", in_specs("robot/mini_cheetah.json"),
                 "*knee=" + in_specs("actuator/d151_knee.json"), "-o", "mine/robot.json"});
  ASSERT_EQ(attached.exit_code, 0) << attached.err;
  EXPECT_NE(attached.out.find("in the place of another"), std::string::npos) << attached.out;
  const auto drives = drives_of(place, "mine/robot.json");
  const auto knee = fs::weakly_canonical(in_repository("specs/actuator/d151_knee.json"));
  const auto hip = fs::weakly_canonical(in_repository("specs/actuator/mini_cheetah_hip.json"));
  const std::map<std::string, fs::path> expected = {
      {"fhip", hip}, {"fknee", knee}, {"rhip", hip}, {"rknee", knee}};
  EXPECT_EQ(drives, expected);
  EXPECT_EQ(place.run({"robot", "export", "mine/robot.json", "--format", "newton", "--actuators"})
                .exit_code,
            0);
}

// A robot without drives gets them, its other keys in their order.
TEST(RobotAttach, GivesDrivesToARobotThatHasNone) {
  const Workplace place;
  ASSERT_EQ(
      place.run({"robot", "import", in_specs("robot/rabbit.urdf"), "-o", "bare.json"}).exit_code,
      0);
  const Outcome bare =
      place.run({"robot", "export", "bare.json", "--format", "newton", "--actuators"});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_NE(bare.err.find("torquewright robot attach"), std::string::npos) << bare.err;
  const json joints = json::parse(place.text("bare.json"))["joints"];
  const std::string joint = joints[joints.size() - 1]["name"];
  const Outcome attached =
      place.run({"robot", "attach", "bare.json", joint + "=" + in_specs("actuator/d151_knee.json"),
                 "-o", "driven.json"});
  ASSERT_EQ(attached.exit_code, 0) << attached.err;
  EXPECT_EQ(drives_of(place, "driven.json").size(), 1u);
  EXPECT_EQ(attached.out.find("reflected_inertia_kg_m2"), std::string::npos) << attached.out;
  EXPECT_EQ(nlohmann::ordered_json::parse(place.text("driven.json")).begin().key(), "kind");
}

// An armature in a simulator's file is that of the drives that the robot had.
TEST(RobotAttach, SaysWhichJointsKeepTheirOwnRotor) {
  const Workplace place;
  place.write("leg.xml", R"(<mujoco><worldbody><body name="thigh">
    <joint name="hip" axis="0 1 0" armature="0.02"/><geom size=".1" mass="1"/><body name="shank">
    <joint name="knee" axis="0 1 0"/><geom size=".1" mass="1"/></body></body></worldbody></mujoco>)");
  ASSERT_EQ(place.run({"robot", "import", "leg.xml", "-o", "leg.json"}).exit_code, 0);
  const Outcome attached =
      place.run({"robot", "attach", "leg.json", "*=" + in_specs("actuator/d151_knee.json"), "-o",
                 "new.json"});
  ASSERT_EQ(attached.exit_code, 0) << attached.err;
  EXPECT_NE(attached.out.find("note: 1 of these joints state reflected_inertia_kg_m2"),
            std::string::npos)
      << attached.out;
}

TEST(RobotAttach, SaysWhatDoesNotFit) {
  const Workplace place;
  const std::string knee = in_specs("actuator/d151_knee.json");
  const auto refusal = [&](const std::string& robot, const Words& drives) {
    Words words = {"robot", "attach", in_specs(robot)};
    words.insert(words.end(), drives.begin(), drives.end());
    words.insert(words.end(), {"-o", "out.json"});
    const Outcome outcome = place.run(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_FALSE(place.has("out.json"));
    return outcome.err;
  };
  EXPECT_EQ(refusal("robot/mini_cheetah.json", {"fnkee=" + knee}),
            "fnkee: fits no joint; did you mean \"fknee\"?\n");
  EXPECT_EQ(refusal("robot/mini_cheetah.json", {"f*=" + knee, "*knee=" + knee}),
            "*knee: fits fknee too, which \"f*\" fits: a joint has one drive\n");
  EXPECT_NE(refusal("robot/hopper.json", {"*ankle*=" + knee}).find("turns: its drives stand at"),
            std::string::npos);
  EXPECT_NE(refusal("robot/mini_cheetah.json", {"fknee"}).find("must be JOINT=ACTUATOR"),
            std::string::npos);
  EXPECT_NE(refusal("robot/mini_cheetah.json", {"fknee=gone.json"}).find("gone.json"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test
