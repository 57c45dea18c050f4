// SPDX-License-Identifier: Apache-2.0
// Robots with closed loops in and out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// A chain of so many links of 1/128 kg, each joint in the file before the one that carries its
/// parent.
std::string long_chain(int links, const std::string& joint_type) {
  std::string text = "<robot name=\"chain\">\n";
  for (int i = 0; i < links; ++i) {
    text += fmt::format(
        "<link name=\"l{}\"><inertial><mass value=\"0.0078125\"/><inertia ixx=\"0.0078125\" "
        "iyy=\"0.0078125\" izz=\"0.0078125\" "
        "ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n",
        i);
  }
  for (int i = links - 1; i > 0; --i) {
    text += fmt::format(
        "<joint name=\"j{0}\" type=\"{2}\"><parent link=\"l{1}\"/><child link=\"l{0}\"/></joint>\n",
        i, i - 1, joint_type);
  }
  return text + "</robot>\n";
}

// Oracle: the masses' sum. 200,000 links would take minutes if each were looked for among all.
TEST(RobotImport, WeldsAVeryLongChain) {
  const Workplace place;
  constexpr int kLinks = 200'000;
  place.write("chain.urdf", long_chain(kLinks, "fixed"));
  const Outcome imported = place.run({"robot", "import", "chain.urdf"});
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  const json bodies = json::parse(imported.out)["bodies"];
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_DOUBLE_EQ(bodies[0]["mass_kg"].get<double>(),
                   kLinks / 128.0);  // binary fractions add exactly
}

TEST(RobotImport, RefusesMoreBodiesThanADocumentHolds) {
  const Workplace place;
  place.write("chain.urdf", long_chain(60'000, "continuous"));
  const Outcome imported = place.run({"robot", "import", "chain.urdf"});
  EXPECT_EQ(imported.exit_code, 2);
  EXPECT_NE(imported.err.find("holds 60000 values, must hold at most 1000"), std::string::npos);
}

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

// Oracle: the file's own words. A mechanism's number takes the place of the actuators' rotors.
TEST_F(LoopedFile, StatesRotorsOfCranksWhereTheFileDoes) {
  const auto mechanisms = [&] {
    const Outcome imported = import(actuators());
    EXPECT_EQ(imported.exit_code, 0) << imported.err;
    return json::parse(place_.text("robot.json"))["mechanisms"];
  };
  for (const json& one : mechanisms()) EXPECT_TRUE(one.contains("reflected_inertia_kg_m2")) << one;
  const std::string bare =
      std::regex_replace(place_.text("looped.xml"), std::regex(" armature=\"[^\"]*\""), "");
  ASSERT_NE(bare, place_.text("looped.xml"));
  place_.write("looped.xml", bare);
  const json left = mechanisms();
  EXPECT_EQ(left.size(), 2u);
  for (const json& one : left) EXPECT_FALSE(one.contains("reflected_inertia_kg_m2")) << one;
}

TEST_F(LoopedFile, NeedsItsActuators) {
  const Outcome imported = import({});
  EXPECT_EQ(imported.exit_code, 2);
  EXPECT_NE(imported.err.find("--actuator knee=FILE"), std::string::npos) << imported.err;
}

const char* const kArm = R"(<robot name="arm"><link name="world"/><link name="a"><inertial>
<mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
<joint name="j" type="continuous"><parent link="world"/><child link="a"/>
<mimic joint="k"/></joint></robot>)";

// Standard output holds the document alone; what was left behind is said all the same.
TEST(RobotImport, SaysItsNotesWhereverTheDocumentGoes) {
  const Workplace place;
  place.write("arm.urdf", kArm);
  for (const Words& output : {Words{}, Words{"-o", "-"}}) {
    Words words{"robot", "import", "arm.urdf"};
    words.insert(words.end(), output.begin(), output.end());
    const Outcome imported = place.run(words);
    EXPECT_EQ(imported.exit_code, 0) << imported.err;
    EXPECT_EQ(imported.out.front(), '{') << imported.out;
    EXPECT_EQ(imported.out.find("note:"), std::string::npos) << imported.out;
    EXPECT_NE(imported.err.find("note: joint \"j\" mimics another"), std::string::npos)
        << imported.err;
  }
}

// Oracle: the lines of the text itself.
TEST(RobotImport, NamesTheFilesOwnLineOfWhatNoDocumentHolds) {
  const Workplace place;
  const auto said = [&](const std::string& mass, const std::string& limit) {
    place.write("arm.urdf",
                "<robot name=\"arm\"><link name=\"world\"/>\n<link name=\"a\"><inertial>"
                "<mass value=\"" +
                    mass +
                    "\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/>"
                    "</inertial></link>\n\n<joint name=\"j\" type=\"revolute\">"
                    "<parent link=\"world\"/><child link=\"a\"/><limit lower=\"-1\" "
                    "upper=\"1\" " +
                    limit + "/></joint></robot>");
    const Outcome imported = place.run({"robot", "import", "arm.urdf"});
    EXPECT_EQ(imported.exit_code, 2) << imported.out;
    return imported.err;
  };
  const std::string joint = said("1", "effort=\"1e-7\"");
  EXPECT_NE(joint.find("arm.urdf: line 4, <joint name=\"j\">: torque_limit_Nm: "),
            std::string::npos)
      << joint;
  const std::string body = said("1e5", "");
  EXPECT_NE(body.find("arm.urdf: line 2, <link name=\"a\">: mass_kg: "), std::string::npos) << body;
}

TEST(RobotImport, WeldsWhatIsLockedWhereThatIsAskedFor) {
  const Workplace place;
  std::string locked = kArm;
  locked.replace(locked.find("<mimic joint=\"k\"/>"), 18, "<limit effort=\"1\" velocity=\"1\"/>");
  locked.replace(locked.find("continuous"), 10, "revolute");
  place.write("arm.urdf", locked);
  const auto joints = [&](const Words& more) {
    Words words{"robot", "import", "arm.urdf"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome imported = place.run(words);
    EXPECT_EQ(imported.exit_code, 0) << imported.err;
    return json::parse(imported.out)["joints"].size();
  };
  EXPECT_EQ(joints({}), 1u);
  EXPECT_EQ(joints({"--weld-locked"}), 0u);
  const Outcome refused =
      place.run({"robot", "import", "arm.urdf", "--format", "mjcf", "--weld-locked"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--weld-locked: is for URDF files"), std::string::npos) << refused.err;
}

TEST(RobotImport, LeavesWordsBehindWhereThatIsAskedFor) {
  const Workplace place;
  place.write("robot.xml",
              "<mujoco wobble=\"1\"><deformable/><worldbody><body name=\"a\"><freejoint/>"
              "<geom size=\"1\"/></body></worldbody></mujoco>");
  EXPECT_EQ(place.run({"robot", "import", "robot.xml", "--ignore", "wobble"}).exit_code, 2);
  const Outcome read =
      place.run({"robot", "import", "robot.xml", "--ignore", "wobble", "--ignore", "deformable"});
  EXPECT_EQ(read.exit_code, 0) << read.err;
  EXPECT_NE(read.err.find("left behind by --ignore deformable: <deformable>"), std::string::npos)
      << read.err;
}

TEST(RobotImport, RefusesOptionsOfMjcfForUrdf) {
  const Workplace place;
  place.write("arm.urdf", kArm);
  for (const Words& option :
       {Words{"--body", "a"}, Words{"--drop-base-armature"}, Words{"--free-couplings"},
        Words{"--link-error", "0.1"}, Words{"--massless-links"}}) {
    Words words{"robot", "import", "arm.urdf"};
    words.insert(words.end(), option.begin(), option.end());
    const Outcome imported = place.run(words);
    EXPECT_EQ(imported.exit_code, 2);
    EXPECT_NE(imported.err.find(option.front() + ": is for MJCF files"), std::string::npos)
        << imported.err;
  }
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
