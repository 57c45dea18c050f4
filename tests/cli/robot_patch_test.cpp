// SPDX-License-Identifier: Apache-2.0
// `robot patch`. Oracles: closed forms of a drive of round numbers, files whose patched text is
// written out here by hand, and `robot import`, which reads XML by another parser.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// At the joint 0.1 * 30 * 10 = 30 Nm at rest, 48 / (0.1 * 10) = 48 rad/s without load, a rotor of
/// 1e-4 * 100 = 0.01 kg m^2, and friction that is stated there.
const char* const kDrive = R"({"kind": "actuator", "version": 1,
 "motor": {"torque_constant_Nm_A": 0.1, "torque_constant_convention": "dc", "resistance_ohm": 0.1,
   "resistance_convention": "dc", "rotor_inertia_kg_m2": 1e-4},
 "drive": {"bus_voltage_V": 48, "peak_current_A": 30},
 "gearbox": {"ratio": 10, "forward_efficiency": 1, "backward_efficiency": 1},
 "effects": [{"effect": "coulomb_friction", "parameters": {"coulomb_Nm": 0.5}},
   {"effect": "viscous_friction", "parameters": {"viscous_Nm_s_rad": 0.02}}]})";

struct PatchDesk : Workplace {
  PatchDesk() { write("drive.json", kDrive); }
};

// What looks like a joint in a comment, in CDATA and among the defaults is none; odd blanks, single
// quotes and a line break of Windows stay.
const char* const kMjcf =
    "<!-- <joint name=\"knee\" damping=\"9\"/> -->\r\n"
    "<mujoco model='leg'>\n"
    "  <default><joint armature=\"0.5\"/><motor ctrlrange=\"-1 1\"/></default>\n"
    "  <asset><mesh name=\"shank\" file=\"shank.obj\"/></asset>\n"
    "  <worldbody>\n"
    "    <body name=\"thigh\"><joint name=\"hip\" axis=\"0 1 0\"/><geom size=\".1\" mass=\"1\"/>\n"
    "      <body name=\"shank\">\n"
    "        <joint  name='knee'   damping = '1.5'\n"
    "                axis=\"0 1 0\" />  <!-- kept > here -->\n"
    "        <geom type=\"mesh\" mesh=\"shank\" mass=\"1\"/>\n"
    "      </body>\n"
    "    </body>\n"
    "  </worldbody>\n"
    "  <actuator>\n"
    "    <motor name=\"knee_drive\" joint=\"knee\" gear=\"-2 0 0 0 0 0\"/>\n"
    "    <motor joint='hip' forcerange='-5 5'/>\n"
    "  </actuator>\n"
    "  <keyframe><key name=\"home\" qpos=\"0 .5\"/></keyframe>\n"
    "</mujoco>\n";

TEST(RobotPatch, WritesNumbersIntoAnMjcfAndNothingElse) {
  const PatchDesk desk;
  desk.write("leg.xml", kMjcf);
  const Outcome outcome =
      desk.run({"robot", "patch", "leg.xml", "kn*=drive.json", "-o", "new.xml"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::string expected = with(kMjcf, "damping = '1.5'", "damping = '0.02'");
  expected = with(expected, "axis=\"0 1 0\" />  <!-- kept",
                  "axis=\"0 1 0\" armature=\"0.01\" frictionloss=\"0.5\" />  <!-- kept");
  expected =
      with(expected, "gear=\"-2 0 0 0 0 0\"/>", "gear=\"-2 0 0 0 0 0\" forcerange=\"-15 15\"/>");
  EXPECT_EQ(desk.text("new.xml"), expected);
  EXPECT_EQ(desk.text("leg.xml"), kMjcf);
  EXPECT_NE(outcome.out.find("\n8 -         <joint  name='knee'   damping = '1.5'\n"
                             "8 +         <joint  name='knee'   damping = '0.02'\n"),
            std::string::npos)
      << outcome.out;
}

TEST(RobotPatch, WritesNothingUnlessToldWhere) {
  const PatchDesk desk;
  desk.write("leg.xml", kMjcf);
  const auto before = desk.files();
  const Outcome shown = desk.run({"robot", "patch", "leg.xml", "knee=drive.json"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_NE(shown.out.find("forcerange=\"-15 15\""), std::string::npos) << shown.out;
  EXPECT_EQ(desk.files(), before);
  EXPECT_EQ(desk.run({"robot", "patch", "leg.xml", "knee=drive.json", "-o", "leg.xml"}).exit_code,
            2);
  EXPECT_EQ(desk.files(), before);
  EXPECT_EQ(desk.run({"robot", "patch", "leg.xml", "knee=drive.json", "-o", "once.xml"}).exit_code,
            0);
  const std::string once = desk.text("once.xml");
  EXPECT_NE(once, kMjcf);
  // What is there already is not written again.
  EXPECT_EQ(
      desk.run({"robot", "patch", "once.xml", "knee=drive.json", "-o", "twice.xml"}).exit_code, 0);
  EXPECT_EQ(desk.text("twice.xml"), once);
}

const char* const kUrdf = R"(<?xml version="1.0"?>
<robot name="leg">
  <!-- the <limit> of the makers: <limit effort="1"/> -->
  <link name="thigh"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="shank"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="foot"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="knee" type="revolute">
    <parent link="thigh"/><child link="shank"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="2" effort="100" velocity="3"/>
  </joint>
  <joint name="ankle" type="revolute">
    <parent link="shank"/><child link="foot"/><axis xyz="0 1 0"/>
    <dynamics damping="0.1"/>
    <limit lower="-1" upper="1" effort="7" velocity="8"/>
  </joint>
</robot>
)";

// Joints that turn are meant by a pattern; whoever names a fixed one is told.
TEST(RobotPatch, PassesFixedJointsByThatAPatternFits) {
  const PatchDesk desk;
  const std::string fixed = with(kUrdf, "<joint name=\"ankle\" type=\"revolute\">",
                                 "<joint name=\"rigid_knee\" type=\"fixed\">");
  desk.write("leg.urdf", fixed);
  const Outcome patched =
      desk.run({"robot", "patch", "leg.urdf", "*knee=drive.json", "-o", "new.urdf"});
  ASSERT_EQ(patched.exit_code, 0) << patched.err;
  EXPECT_TRUE(patched.out.starts_with("leg.urdf: 1 joint changes\n")) << patched.out;
  EXPECT_NE(desk.text("new.urdf").find(fixed.substr(fixed.find("<joint name=\"rigid_knee\""))),
            std::string::npos);
  const Outcome named = desk.run({"robot", "patch", "leg.urdf", "rigid_knee=drive.json"});
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_NE(named.err.find("rigid_knee is fixed"), std::string::npos) << named.err;
  const Outcome none = desk.run({"robot", "patch", "leg.urdf", "rigid*=drive.json"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("fits no joint of leg.urdf"), std::string::npos) << none.err;
}

TEST(RobotPatch, WritesNumbersIntoAUrdfThatAnotherParserReads) {
  const PatchDesk desk;
  desk.write("leg.urdf", kUrdf);
  ASSERT_EQ(desk.run({"robot", "patch", "leg.urdf", "knee=drive.json", "-o", "new.urdf"}).exit_code,
            0);
  std::string expected =
      with(kUrdf, "effort=\"100\" velocity=\"3\"", "effort=\"30\" velocity=\"48\"");
  expected = with(expected, "\"revolute\">\n    <parent link=\"thigh\"",
                  "\"revolute\">\n    <dynamics damping=\"0.02\" friction=\"0.5\"/>\n    "
                  "<parent link=\"thigh\"");
  EXPECT_EQ(desk.text("new.urdf"), expected);
  json robots[2];
  for (const int i : {0, 1}) {
    const Outcome read = desk.run({"robot", "import", i == 0 ? "leg.urdf" : "new.urdf"});
    ASSERT_EQ(read.exit_code, 0) << read.err;
    robots[i] = json::parse(read.out);
  }
  for (json& joint : robots[1]["joints"]) {
    if (joint["name"] != "knee") continue;
    EXPECT_EQ(joint["torque_limit_Nm"], 30);
    EXPECT_EQ(joint["speed_limit_rad_s"], 48);
    EXPECT_EQ(joint["damping_Nm_s_rad"], 0.02);
    EXPECT_EQ(joint["dry_friction_Nm"], 0.5);
  }
  const auto others = [](json robot) {
    robot.erase("provenance");
    for (json& joint : robot["joints"]) {
      if (joint["name"] == "knee") {
        for (const char* key : {"torque_limit_Nm", "speed_limit_rad_s", "damping_Nm_s_rad",
                                "dry_friction_Nm", "static_friction_Nm"}) {
          joint.erase(key);
        }
      }
    }
    return robot;
  };
  EXPECT_EQ(others(robots[0]), others(robots[1]));
}

// Whatever would need another change than that of a number.
TEST(RobotPatch, RefusesWhatWouldChangeMore) {
  struct Case {
    std::string from, to, drive, said;
  };
  const Case cases[] = {
      {"", "", "elbow=drive.json", "elbow: fits no joint of leg.xml"},
      {"", "", "kne=drive.json", "did you mean \"knee\"?"},
      {"name='knee'", "name='knee' type='slide'", "knee=drive.json",
       "leg.xml: line 8: knee is of type slide"},
      {"gear=\"-2 0 0 0 0 0\"", "forcelimited=\"false\"", "knee=drive.json",
       "leg.xml: line 15: forcelimited is \"false\""},
      {"gear=\"-2 0 0 0 0 0\"", "gear=\"0\"", "knee=drive.json",
       "gear \"0\" does not begin with a number"},
      {"<motor ctrlrange=\"-1 1\"/></default>", "<motor gear=\"3\"/></default>", "h*=drive.json",
       "leg.xml: line 16: its gear stands among the defaults, at line 3"},
      {"name=\"hip\"", "name=\"knee\"", "knee=drive.json", "a second joint is called knee"},
      {"<asset>", "<include file=\"arm.xml\"/><asset>", "elbow=drive.json", "it takes in arm.xml"},
      {"</mujoco>", "</mujoc>", "knee=drive.json", "leg.xml"},
      {"", "", "knee=gone.json", "gone.json"}};
  for (const Case& each : cases) {
    const PatchDesk desk;
    desk.write("leg.xml", each.from.empty() ? std::string(kMjcf) : with(kMjcf, each.from, each.to));
    const auto before = desk.files();
    const Outcome outcome = desk.run({"robot", "patch", "leg.xml", each.drive, "-o", "new.xml"});
    EXPECT_EQ(outcome.exit_code, 2) << each.to << outcome.out;
    EXPECT_NE(outcome.err.find(each.said), std::string::npos) << each.said << "\n" << outcome.err;
    EXPECT_EQ(desk.files(), before);
  }
  const PatchDesk urdf;
  urdf.write("leg.urdf", with(kUrdf, "<dynamics damping=\"0.1\"/>", "<limit effort=\"1\"/>"));
  const auto before = urdf.files();
  const Outcome two = urdf.run({"robot", "patch", "leg.urdf", "ankle=drive.json", "-o", "n.urdf"});
  EXPECT_EQ(two.exit_code, 2) << two.out;
  EXPECT_NE(two.err.find("leg.urdf: line 14: a second <limit> of one joint"), std::string::npos)
      << two.err;
  EXPECT_EQ(urdf.files(), before);
  const PatchDesk desk;
  desk.write("leg.xml", kMjcf);
  const Outcome twice = desk.run({"robot", "patch", "leg.xml", "k*=drive.json", "*ee=drive.json"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_NE(twice.err.find("*ee: fits knee too"), std::string::npos) << twice.err;
}

}  // namespace
}  // namespace torquewright::cli_test
