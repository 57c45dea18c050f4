// SPDX-License-Identifier: Apache-2.0
// What readers of foreign files take from words beside mass and kinematics, and what they refuse by
// name. Oracles: closed forms, and the words themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "robot/draft/mended_inertia.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "robot/urdf/urdf_writer.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/imported_notes.hpp"

namespace torquewright::hopper {
namespace {

using test::all_of;
using test::refusal;

const std::string kPart = R"(<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>)";
const ImportFileOptions kMends{"", false, false, true};
const std::string kUnit =
    R"(<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>)";

Imported mjcf(const std::string& sections, const std::string& top,
              const ImportFileOptions& options = {}) {
  const test::ScratchFolder folder;
  return read_mjcf(folder.write("robot.xml", "<mujoco>" + sections + "<worldbody>" + top +
                                                 "</worldbody></mujoco>"),
                   options);
}

Imported urdf(const std::string& content, const ImportFileOptions& options = {}) {
  const test::ScratchFolder folder;
  return read_urdf(folder.write("robot.urdf", "<robot name='r'>" + content + "</robot>"), options);
}

const std::string kTwoBodies = R"(<body name="a"><freejoint/>)" + kPart +
                               R"(<body name="b"><joint name="j" range="-30 60"/>)" + kPart +
                               "</body></body>";

TEST(MjcfWords, ThatWouldChangeMassOrKinematicsAreRefusedByName) {
  const std::vector<std::array<std::string, 3>> refused{
      {"", R"(<body name="a"><replicate count="3" offset="1 0 0"><body/></replicate></body>)",
       "line 1, <replicate>: the element <replicate> is not read"},
      {"", R"(<replicate count="3"><body name="a"/></replicate><body name="b"/>)", "<replicate>"},
      {"", R"(<body name="a"><composite/></body>)", "<composite>"},
      {"", R"(<body name="a" mocap="true"/>)", "mocap of <body>"},
      {"", R"(<body name="a" wobble="1"/>)", "wobble of <body> is not known"},
      {"<wobble/>", kTwoBodies, "<wobble> is not known"},
      {"<deformable/>", kTwoBodies, "<deformable>"},
      {"<compiler alignfree='true'/>", kTwoBodies, "alignfree"},
      {"<tendon><fixed name='t' armature='0.1'><joint joint='j'/></fixed></tendon>", kTwoBodies,
       "armature of <fixed>"},
      {"<default><joint armature='0.1'/></default>",
       R"(<body name="a"><joint type="free"/>)" + kPart + "</body>", "its armature of 0.1"},
      {"<equality/><equality><joint joint1='j'/></equality>", kTwoBodies, "holds \"j\""},
      {"<equality><connect body1='a' body2='b' anchor='0 0 0'/></equality>", kTwoBodies,
       "no linkage that is read"},
      {"", R"(<body name="a"><freejoint/><geom type="mesh" mesh="m"/></body>)",
       "no mesh is opened"},
      {"", R"(<body name="a"><joint/><geom type="box" size="1"/></body>)", "sizes are missing"},
      {"", R"(<body name="a"><joint/>)" + kPart + R"(<body name="b"><joint/></body></body>)",
       "has no mass, and moves"},
      {"", R"(<body name="a"><joint/></body>)", "has no mass, and moves"},
      {"", R"(<body name="a"><joint class="leg"/></body>)", "no default has class \"leg\""},
      {"", R"(<body name="a" quat="1 0 0 0" euler="0 0 0"/>)", "several ways"},
      {"", kTwoBodies + R"(<body name="c"><joint/></body>)", "name its body by --body"},
      {"<include file='other.xml'/>", kTwoBodies, "is not there"},
      {"<compiler eulerseq='xyq'/>", kTwoBodies, "three of x, y, z"},
      {"<option gravity='0 1 -9'/>", kTwoBodies, "along -z"}};
  for (const auto& [sections, top, message] : refused) {
    const std::string said = refusal([&] { return mjcf(sections, top); });
    EXPECT_NE(said.find(message), std::string::npos) << sections << top << "\n" << said;
  }
}

TEST(MjcfWords, OfEqualitiesElsewhereOrNotActiveDoNotCount) {
  const std::string ball = R"(<body name="c"/><body name="d"/>)";
  EXPECT_NO_THROW(mjcf("<equality><weld body1='c' body2='d'/></equality>", kTwoBodies + ball));
  EXPECT_NO_THROW(mjcf("<equality><weld body1='a' active='false'/></equality>", kTwoBodies));
  const std::string off = "<default><equality active='false'/></default>";
  EXPECT_NO_THROW(mjcf(off + "<equality><weld body1='a'/></equality>", kTwoBodies));
  EXPECT_ANY_THROW(mjcf(off + "<equality><weld body1='a' active='true'/></equality>", kTwoBodies));
}

TEST(MjcfWords, MayBeLeftOutWhereThatIsAskedForAndSaid) {
  const std::string joint = "<equality><joint joint1='j' polycoef='0 1'/></equality>";
  const Imported freed = mjcf(joint, kTwoBodies, {"", false, true});
  EXPECT_NE(all_of(freed.notes).find("holds \"j\" is left out"), std::string::npos);
  const std::string weld = "<equality><weld body1='a' body2='b'/></equality>";
  EXPECT_NE(refusal([&] { return mjcf(weld, kTwoBodies, {"", false, true}); }), "was read");
  const std::string free =
      R"(<body name="a"><joint type="free" armature="0.2"/>)" + kPart + "</body>";
  EXPECT_NE(all_of(mjcf("", free, {"", true}).notes).find("armature of 0.2"), std::string::npos);
}

TEST(MjcfWords, ThatAreLeftBehindAreListedOnce) {
  const std::string notes =
      all_of(mjcf("<sensor/><sensor/><visual/>",
                  R"(<body name="a"><site/><geom/><joint name="j" springdamper="0.1 1"
              damping="0"/>)" +
                      kPart + "</body>")
                 .notes);
  EXPECT_NE(notes.find("springdamper of <joint> is a force"), std::string::npos) << notes;
  EXPECT_NE(notes.find(": j\n"), std::string::npos) << notes;
  EXPECT_EQ(notes.find("damping"), std::string::npos) << notes;
  EXPECT_NE(notes.find("<sensor>, <site>, <visual>"), std::string::npos) << notes;
}

/// The limit of the joint "j" of the second body.
double effort(const std::string& joint, const std::string& actuators) {
  const Imported read =
      mjcf("<actuator>" + actuators + "</actuator>", "<body name='a'><freejoint/>" + kPart +
                                                         "<body name='b'><joint name='j' " + joint +
                                                         "/>" + kPart + "</body></body>");
  return read.robot.tree.bodies[1].joint.limits.effort_max;
}

// Oracle: gear times force, and the smaller of what limits it.
TEST(MjcfWords, OfActuatorsLimitEffort) {
  EXPECT_EQ(effort("", "<motor joint='j' gear='5' ctrlrange='-3 3'/>"), 15);
  EXPECT_EQ(effort("", "<motor joint='j' gear='5' ctrlrange='-3 3' forcerange='-2 2'/>"), 10);
  EXPECT_EQ(effort("", "<position joint='j' gear='-5' ctrlrange='-3 3' forcerange='-2 4'/>"), 10);
  EXPECT_EQ(effort("", "<general joint='j' gainprm='7' ctrlrange='-3 3'/>"), 21);
  EXPECT_EQ(effort("",
                   "<motor joint='j' forcerange='-2 2'/><motor joint='j' gear='2' "
                   "forcerange='-3 3'/>"),
            8);
  EXPECT_EQ(effort("actuatorfrcrange='-4 4'", "<motor joint='j' forcerange='-9 9'/>"), 4);
  EXPECT_EQ(effort("actuatorfrcrange='-4 4' actuatorfrclimited='false'", ""), INFINITY);
  EXPECT_EQ(effort("", "<motor joint='j' ctrlrange='-3 3' ctrllimited='false'/>"), INFINITY);
  EXPECT_EQ(effort("", "<motor joint='j' forcerange='-9 9'/><position joint='j'/>"), INFINITY);
}

// Oracle: MuJoCo's reference: a range of 0 0 is the default, which says that none holds.
TEST(MjcfWords, OfActuatorsThatStateNoLimitLeaveNone) {
  EXPECT_EQ(effort("actuatorfrcrange='0 0'", ""), INFINITY);
  EXPECT_EQ(effort("", "<motor joint='j' forcerange='0 0'/>"), INFINITY);
}

TEST(MjcfWords, OfActuatorsWhoseLimitWouldBeLostAreRefused) {
  const std::vector<std::array<std::string, 3>> refused{
      {"actuatorfrcrange='0 5'", "", "actuatorfrcrange=\"0 5\" pushes one way only"},
      {"actuatorfrcrange='5 -5'", "", "actuatorfrcrange=\"5 -5\": the first number is not below"},
      {"", "<motor joint='j' forcerange='2 -2'/>", "forcerange=\"2 -2\": the first number"},
      {"", "<motor joint='j' forcerange='0 2'/>", "forcerange=\"0 2\" pushes one way only"},
      {"", "<motor joint='j' forcerange='-2 0'/>", "forcerange=\"-2 0\" pushes one way only"},
      {"", "<motor joint='j' ctrlrange='0 1'/>", "ctrlrange=\"0 1\" pushes one way only"},
      {"", "<motor joint='j' forcerange='0 0' forcelimited='true'/>", "forcerange=\"0 0\": the"},
      {"", "<motor name='m' joint='j' forcrange='-2 2'/>", "name=\"m\">: the attribute forcrange"},
      {"", "<motor joint='zz' forcerange='-2 2'/>", "no body has a joint \"zz\""},
      {"", "<motor joint='j' gear='0' forcerange='-2 2'/>", "a gear of 0"},
      {"", "<general joint='j' gainprm='0' ctrlrange='-2 2'/>", "a gain of 0"}};
  for (const auto& [joint, actuators, message] : refused) {
    const std::string said = refusal([&] { return effort(joint, actuators); });
    EXPECT_NE(said.find(message), std::string::npos) << joint << actuators << "\n" << said;
  }
  const std::string misspelt = "<default><motor forcrange='-2 2'/></default>";
  const std::string said = refusal([&] { return mjcf(misspelt, kTwoBodies); });
  EXPECT_NE(said.find("forcrange of <motor> is not known"), std::string::npos) << said;
}

TEST(MjcfWords, OfActuatorsElsewhereAreNamed) {
  const std::string notes =
      all_of(mjcf("<tendon><fixed name='t'><joint joint='j'/></fixed></tendon>"
                  "<actuator><motor tendon='t'/><motor name='m' tendon='t'/></actuator>",
                  kTwoBodies)
                 .notes);
  EXPECT_NE(notes.find("not held: <motor> of line 1, m\n"), std::string::npos) << notes;
}

TEST(MjcfWords, OfATendonsLimitsAreNamed) {
  const std::string notes =
      all_of(mjcf("<tendon><fixed name='t' range='-1 2' limited='true' actuatorfrcrange='-5 5'>"
                  "<joint joint='j'/></fixed>"
                  "<fixed name='free' range='-1 2' limited='false'><joint joint='j'/></fixed>"
                  "</tendon>",
                  kTwoBodies)
                 .notes);
  EXPECT_NE(notes.find("the tendon t's range=\"-1 2\" is left out"), std::string::npos) << notes;
  EXPECT_NE(notes.find("the tendon t's actuatorfrcrange=\"-5 5\""), std::string::npos) << notes;
  EXPECT_EQ(notes.find("the tendon free"), std::string::npos) << notes;
}

TEST(MjcfWords, OfAPlanarBasesJointsAreNamed) {
  const std::string notes =
      all_of(mjcf("", R"(<body name="a"><joint name="x" type="slide" axis="1 0 0" range="-2 3"/>
                 <joint name="z" type="slide" axis="0 0 1" damping="4"/>
                 <joint name="pitch" axis="0 1 0" range="-90 90"/>)" +
                          kPart + "</body>")
                 .notes);
  EXPECT_NE(notes.find("x's range of -2 to 3 m is left out"), std::string::npos) << notes;
  EXPECT_NE(notes.find("z's damping, friction or spring is left out"), std::string::npos) << notes;
  EXPECT_NE(notes.find("pitch's range of -1.5708 to 1.5708 rad"), std::string::npos) << notes;
  EXPECT_EQ(notes.find("z's range"), std::string::npos) << notes;
}

// What stands once counts; of two, one would not.
TEST(MjcfWords, ThatStandTwiceAreRefused) {
  const std::string other = R"(<inertial pos="0 0 0" mass="9" diaginertia="1 1 1"/>)";
  const std::vector<std::array<std::string, 3>> refused{
      {"", "<body name='a'><freejoint/>" + kPart + other + "</body>",
       "line 1, <inertial>: stands in <body> for the second time"},
      {"",
       "<body name='a'><freejoint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1' "
       "fullinertia='2 2 2 0 0 0'/></body>",
       "both diaginertia and fullinertia"},
      {"<default><default class='leg'><joint armature='1'/></default>"
       "<default class='leg'><joint armature='2'/></default></default>",
       kTwoBodies, "the default class \"leg\" stands twice"}};
  for (const auto& [sections, top, message] : refused) {
    const std::string said = refusal([&] { return mjcf(sections, top); });
    EXPECT_NE(said.find(message), std::string::npos) << sections << top << "\n" << said;
  }
  const test::ScratchFolder folder;
  const auto two = folder.write("two.xml", "<mujoco/>\n<mujoco/>");
  const std::string said = refusal([&] { return read_mjcf(two); });
  EXPECT_NE(said.find("line 2: <mujoco> follows <mujoco> of line 1"), std::string::npos) << said;
}

TEST(MjcfWords, OfLimitsNeedNotSayThatTheyHold) {
  const auto lower = [](const std::string& compiler, const std::string& joint) {
    return mjcf(compiler,
                "<body name='a'><joint name='j' range='-90 90' " + joint + "/>" + kPart + "</body>")
        .robot.tree.bodies[1]
        .joint.limits.position_min;
  };
  EXPECT_EQ(lower("", ""), -M_PI / 2);
  EXPECT_EQ(lower("", "limited='false'"), -INFINITY);
  // MuJoCo refuses it too.
  EXPECT_NE(refusal([&] {
              return lower("<compiler autolimits='false'/>", "");
            }).find("does not say whether it holds"),
            std::string::npos);
  EXPECT_EQ(lower("<compiler autolimits='false'/>", "limited='true'"), -M_PI / 2);
}

TEST(MjcfIncludes, StandInTheirPlaceAndNameTheirFileInFaults) {
  const test::ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "parts");
  const std::string part = "<body name='b'><joint name='j'/>" + kPart + "</body>";
  folder.write("parts/leg.xml", "<mujocoinclude>" + part + "</mujocoinclude>");
  const auto main =
      folder.write("robot.xml", "<mujoco><worldbody><body name='a'><freejoint/>" + kPart +
                                    "<include file='parts/leg.xml'/></body></worldbody></mujoco>");
  EXPECT_EQ(read_mjcf(main).robot.tree.bodies[1].name, "b");
  folder.write("parts/leg.xml", "<mujocoinclude>\n<body wobble='1'/></mujocoinclude>");
  const std::string said = refusal([&] { return read_mjcf(main); });
  EXPECT_NE(said.find("leg.xml: line 2, <body>: the attribute wobble"), std::string::npos) << said;
  folder.write("parts/leg.xml", "<mujocoinclude><include file='robot.xml'/></mujocoinclude>");
  EXPECT_NE(refusal([&] { return read_mjcf(main); }).find("included already"), std::string::npos);
}

TEST(MjcfBodies, ThatDoNotMoveAreNotAskedFor) {
  const Imported read = mjcf("", kTwoBodies + R"(<body name="table"><geom size="1"/></body>)");
  EXPECT_EQ(read.robot.tree.bodies[0].name, "a");
  EXPECT_NE(all_of(read.notes).find("left out: table"), std::string::npos);
  const std::string ball = R"(<body name="ball"><freejoint/><geom size="1"/></body>)";
  EXPECT_EQ(mjcf("", kTwoBodies + ball, {"ball"}).robot.tree.bodies[0].name, "ball");
}

// Bodies without mass between joints go through a document and come back.
TEST(MjcfBodies, WithSeveralJointsMakeADocument) {
  const Imported read =
      mjcf("", "<body name='a'><freejoint/>" + kPart +
                   "<body name='b'><joint name='j'/><joint name='k' axis='1 0 0'/>" + kPart +
                   "</body></body>");
  const test::ScratchFolder folder;
  const Robot back = read_robot(folder.write("r.json", robot_json(read.robot).dump())).robot;
  ASSERT_EQ(back.tree.bodies.size(), 3u);
  EXPECT_EQ(back.tree.bodies[1].name, "b.j");
  EXPECT_EQ(back.tree.bodies[1].inertia.mass_kg, 0);
}

const std::string kEnds = "<parent link='world'/><child link='a'/>";
const std::string kArm = "<link name='world'/><link name='a'>" + kUnit + "</link>";

TEST(UrdfWords, ThatWouldChangeMassOrKinematicsAreRefusedByName) {
  const std::vector<std::array<std::string, 2>> refused{
      {kArm + "<joint name='j' type='planar'><parent link='world'/><child link='a'/></joint>",
       "type \"planar\""},
      {kArm + "<joint name='j' type='revolute'><parent link='world'/><child link='a'/>"
              "<drake:screw_thread_pitch/></joint>",
       "drake:screw_thread_pitch"},
      {kArm + "<joint name='j' type='fixed'><parent link='world'/><child link='a'/>"
              "<origin quat_xyzw='0 0 0 1'/></joint>",
       "quat_xyzw of <origin>"},
      {kArm + "<joint name='j' type='fixed'><parent link='world'/><child link='a'/></joint>"
              "<gazebo><joint name='k'><parent>a</parent><child>b</child></joint></gazebo>",
       "closes a loop"},
      {kArm + "<link name='b'/><joint name='j' type='fixed'><parent link='world'/><child link='a'/>"
              "</joint><joint name='k' type='floating'><parent link='a'/><child link='b'/></joint>",
       "floats"}};
  for (const auto& [content, message] : refused) {
    const std::string said = refusal([&] { return urdf(content); });
    EXPECT_NE(said.find(message), std::string::npos) << content << "\n" << said;
  }
}

// Oracle: urdfdom, and with it MuJoCo, Pinocchio, Bullet and Isaac Sim, skips what URDF does not
// define. So do we, once each and counted.
TEST(UrdfWords, ThatUrdfDoesNotDefineAreSkippedAndSaidOnce) {
  const std::string joint =
      "<joint name='j' type='revolute' wobbles='true'><parent link='world'/><child link='a'/>"
      "<limit lower='-1' upper='1'/><wobbling by='1'/><wobbling/></joint>";
  const Imported with = urdf(kArm + joint + "<wobble/>");
  const std::string said = all_of(with.notes);
  EXPECT_NE(said.find("<wobble>, <wobbling> (2 times), wobbles of <joint>"), std::string::npos)
      << said;
  std::string plain = joint;
  plain.erase(plain.find("<wobbling"), plain.rfind("</joint>") - plain.find("<wobbling"));
  EXPECT_EQ(robot_json(with.robot), robot_json(urdf(kArm + plain).robot));
}

// Oracle: their own readers' pages: drawing, collapsing of fixed joints, drives of a simulator.
TEST(UrdfWords, OfOtherReadersThatMoveNothingAreNeutral) {
  const std::string said =
      all_of(urdf(kArm + "<joint name='j' type='continuous' dont_collapse='true'>" + kEnds +
                  "<safety_controller k_velocity='1'/><joint_properties damping='1'/></joint>")
                 .notes);
  EXPECT_NE(said.find("changes neither mass nor kinematics: <joint_properties>, "
                      "<safety_controller>, dont_collapse of <joint>"),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("does not define"), std::string::npos) << said;
}

// Oracle: the same file without the words.
TEST(Words, ThatAreRefusedAreLeftBehindWhereThatIsAskedFor) {
  ImportFileOptions leaves;
  leaves.ignored_words = {"replicate", "wobble", "quat_xyzw", "unheard"};
  const std::string wobbling =
      R"(<body name="a" wobble="1"><freejoint/><replicate count="3"><body/></replicate>)" + kPart +
      "</body>";
  EXPECT_NE(refusal([&] { return mjcf("", wobbling); }).find("--ignore wobble leaves it behind"),
            std::string::npos);
  const Imported read = mjcf("", wobbling, leaves);
  EXPECT_EQ(robot_json(read.robot),
            robot_json(mjcf("", R"(<body name="a"><freejoint/>)" + kPart + "</body>").robot));
  const std::string said = all_of(read.notes);
  EXPECT_NE(said.find("left behind by --ignore replicate: <replicate>\n"), std::string::npos)
      << said;
  EXPECT_NE(said.find("left behind by --ignore wobble: wobble of <body>\n"), std::string::npos)
      << said;
  EXPECT_NE(said.find("--ignore unheard: nothing that is refused is called so"), std::string::npos)
      << said;
  const std::string turned = kArm + "<joint name='j' type='continuous'>" + kEnds +
                             "<origin xyz='0 0 1' quat_xyzw='0 0 0 1'/></joint>";
  EXPECT_NE(refusal([&] { return urdf(turned); }), "was read");
  EXPECT_EQ(urdf(turned, leaves).robot.tree.bodies[1].joint.p_PB_m.z(), 1);
}

// Oracle: what the words mean to Gazebo (SDFormat).
TEST(UrdfWords, OfGazeboAreSaidWithWhatTheyWouldChange) {
  const std::string joint =
      "<joint name='j' type='revolute'><parent link='world'/><child link='a'/>"
      "<limit lower='-1' upper='1'/></joint>";
  const std::string said = all_of(
      urdf(kArm + joint +
           "<gazebo reference='j'><springStiffness>3</springStiffness></gazebo>"
           "<gazebo reference='a'><mu1>0.4</mu1><gravity>true</gravity><material>Red</material>"
           "</gazebo><gazebo><static>true</static></gazebo>")
          .notes);
  for (const char* sentence :
       {"<springStiffness> in <gazebo> is not read: stiffness_Nm_rad and spring_rest_rad of a "
        "joint "
        "hold a spring: j",
        "<mu1> in <gazebo> is not read: the ground's friction is friction_coefficient of a "
        "contact: a",
        "<static> in <gazebo> is not read: a root that stands fixed is a link named \"world\": the "
        "whole robot",
        "left behind of <gazebo>: gravity, material"}) {
    EXPECT_NE(said.find(sentence), std::string::npos) << sentence << "\n" << said;
  }
  EXPECT_EQ(said.find("floats"), std::string::npos) << said;
}

// Oracle: Gazebo's plugins and sensors name links and joints that are there; a joint of SDFormat
// beside them is one more.
TEST(UrdfWords, InsidePluginsAndSensorsOfGazeboAddNothing) {
  const std::string joint =
      "<joint name='j' type='revolute'><parent link='world'/><child link='a'/>"
      "<limit lower='-1' upper='1'/></joint>";
  const std::string loop = "<joint name='k'><parent>a</parent><child>b</child></joint>";
  const auto in = [&](const std::string& what) {
    return refusal([&] { return urdf(kArm + joint + "<gazebo>" + what + "</gazebo>"); });
  };
  EXPECT_EQ(in("<plugin><plot><link>a</link></plot>" + loop + "</plugin>"), "was read");
  EXPECT_EQ(in("<sensor><plugin><link>a</link></plugin>" + loop + "</sensor>"), "was read");
  EXPECT_NE(in("<link name='b'/>").find("<link name=\"b\">: adds to the robot"), std::string::npos);
  EXPECT_NE(in("<plugin/>" + loop).find("closes a loop"), std::string::npos);
  EXPECT_NE(in("<model>" + loop + "</model>").find("closes a loop"), std::string::npos);
}

TEST(UrdfWords, SayThatARootWhichNoJointCarriesFloats) {
  const std::string said = all_of(urdf("<link name='base'>" + kUnit + "</link>").notes);
  EXPECT_NE(said.find("\"base\" floats"), std::string::npos) << said;
}

TEST(UrdfWords, ThatStandTwiceAreRefused) {
  const auto joint = [](const std::string& more) {
    return kArm + "<joint name='j' type='revolute'>" + kEnds + more + "</joint>";
  };
  const auto link = [](const std::string& inertial) {
    return "<link name='world'/><link name='a'>" + inertial +
           "</link><joint name='j' type='fixed'>" + kEnds + "</joint>";
  };
  const std::string inertia = "<inertia ixx='1' iyy='1' izz='1'/>";
  const std::string limit = "<limit lower='-1' upper='1'/>";
  const std::vector<std::array<std::string, 2>> refused{
      {joint(limit + limit), "<limit>: stands in <joint> for the second time"},
      {joint("<axis xyz='0 1 0'/><axis xyz='1 0 0'/>"), "<axis>: stands in <joint>"},
      {joint("<origin xyz='0 0 1'/><origin xyz='0 0 2'/>"), "<origin>: stands in <joint>"},
      {joint("<parent link='a'/>"), "<parent>: stands in <joint>"},
      {joint("<child link='world'/>"), "<child>: stands in <joint>"},
      {link(kUnit + kUnit), "<inertial>: stands in <link>"},
      {link("<inertial><mass value='1'/><mass value='2'/>" + inertia + "</inertial>"),
       "<mass>: stands in <inertial>"},
      {link("<inertial><mass value='1'/>" + inertia + inertia + "</inertial>"),
       "<inertia>: stands in <inertial>"},
      {link("<inertial><mass/>" + inertia + "</inertial>"), "<mass>: value is missing"}};
  for (const auto& [content, message] : refused) {
    const std::string said = refusal([&] { return urdf(content); });
    EXPECT_NE(said.find(message), std::string::npos) << content << "\n" << said;
  }
  const std::string said = refusal([&] { return urdf(kArm + "</robot><robot name='s'>"); });
  EXPECT_NE(said.find("<robot> follows <robot>"), std::string::npos) << said;
}

TEST(UrdfJoints, WithLimitsBelowZeroAreRefused) {
  const auto limited = [](const std::string& limits) {
    return urdf(kArm + "<joint name='j' type='continuous'>" + kEnds + "<limit " + limits +
                "/></joint>");
  };
  for (const char* limits : {"effort='-10'", "velocity='-10'"}) {
    const std::string said = refusal([&] { return limited(limits); });
    EXPECT_NE(said.find("=-10 is below 0"), std::string::npos) << said;
  }
  const dynamics::JointLimits read =
      limited("effort='0' velocity='0'").robot.tree.bodies[1].joint.limits;
  EXPECT_EQ(read.effort_max, INFINITY);
  EXPECT_EQ(read.speed_max, INFINITY);
}

TEST(UrdfTransmissions, SayWhatOfThemIsNotRead) {
  const auto notes = [](const std::string& motor) {
    return all_of(urdf(kArm + "<joint name='j' type='continuous'>" + kEnds +
                       "</joint><transmission name='t'><joint name='j'/><actuator name='m'>" +
                       motor + "</actuator></transmission>")
                      .notes);
  };
  EXPECT_NE(
      notes("<mechanicalReduction>50</mechanicalReduction>").find("<mechanicalReduction> of 50"),
      std::string::npos);
  EXPECT_NE(notes("<motorInertia>0.001</motorInertia>").find("<motorInertia> of 0.001 is not read"),
            std::string::npos);
  EXPECT_EQ(notes("<mechanicalReduction>1</mechanicalReduction>"), "");
  const std::string rotor = "<drake:rotor_inertia value='0.1'/>";
  const auto refused = [&](const std::string& transmission) {
    return refusal([&] {
      return urdf(kArm + "<joint name='j' type='continuous'>" + kEnds + "</joint>" + transmission);
    });
  };
  const auto of = [&](const std::string& joint) {
    return "<transmission><joint name='" + joint + "'/><actuator>" + rotor +
           "</actuator></transmission>";
  };
  EXPECT_NE(refused(of("zz")).find("is no joint of the file"), std::string::npos);
  EXPECT_NE(refused(of("j") + of("j")).find("another transmission"), std::string::npos);
  EXPECT_EQ(refused(of("j")), "was read");
}

TEST(XmlFiles, InOtherEncodingsAreRefusedWhereThatMatters) {
  const test::ScratchFolder folder;
  const auto read = [&](const std::string& declaration, const std::string& name) {
    return refusal([&] {
      return read_urdf(folder.write("r.urdf", declaration + "<robot name='" + name +
                                                  "'>\n<link name='a'>" + kUnit +
                                                  "</link></robot>"));
    });
  };
  const std::string latin = "<?xml version='1.0' encoding='ISO-8859-1'?>\n";
  EXPECT_EQ(read(latin, "plain"), "was read");
  EXPECT_EQ(read("<?xml version='1.0' encoding='UTF-8'?>", "caf\xC3\xA9"), "was read");
  EXPECT_EQ(read("", "caf\xC3\xA9"), "was read");
  const std::string declared = read(latin, "caf\xE9");
  EXPECT_NE(declared.find("encoding=\"ISO-8859-1\" is not read, and line 2"), std::string::npos)
      << declared;
  const std::string silent = read("", "caf\xE9");
  EXPECT_NE(silent.find("line 1: is not UTF-8"), std::string::npos) << silent;
  // RFC 3629, 3 and 10: an overlong "/" and half of a surrogate pair.
  for (const char* forbidden : {"caf\xE0\x80\xAF", "caf\xED\xA0\x80"}) {
    EXPECT_NE(read("", forbidden).find("line 1: is not UTF-8"), std::string::npos);
  }
}

// Oracle: the turn by the limits' angle about the axis.
TEST(UrdfJoints, OfOnePositionAreWelds) {
  const Imported read =
      urdf(kArm + "<link name='b'>" + kUnit +
           "</link>"
           "<joint name='j' type='continuous'><parent link='world'/><child link='a'/></joint>"
           "<joint name='k' type='revolute'><parent link='a'/><child link='b'/>"
           "<origin xyz='0 0 1'/><axis xyz='0 1 0'/><limit lower='0.5' upper='0.5'/></joint>"
           "<link name='c'>" +
           kUnit +
           "</link>"
           "<joint name='l' type='continuous'><parent link='b'/><child link='c'/>"
           "<origin xyz='1 0 0'/></joint>");
  ASSERT_EQ(read.robot.tree.bodies.size(), 3u);
  EXPECT_EQ(read.robot.tree.bodies[1].inertia.mass_kg, 2);
  const Eigen::Vector3d place_m = read.robot.tree.bodies[2].joint.p_PB_m;
  EXPECT_LE((place_m - Eigen::Vector3d(std::cos(0.5), 0, 1 - std::sin(0.5))).norm(), 1e-15);
  EXPECT_NE(all_of(read.notes).find("\"k\" is welded at 0.5"), std::string::npos);
}

/// The arm's one joint of that type and limit; none where it is a weld.
std::optional<dynamics::JointLimits> limits_of(const std::string& type, const std::string& limit,
                                               const ImportFileOptions& options = {}) {
  const Robot robot =
      urdf(kArm + "<joint name='j' type='" + type + "'>" + kEnds + "<limit " + limit + "/></joint>",
           options)
          .robot;
  if (robot.tree.bodies.size() == 1) return std::nullopt;
  return robot.tree.bodies[1].joint.limits;
}

// Oracle: MuJoCo's reader of URDF (mujoco_reads_test.cpp asks it), Pinocchio's, Bullet's, Isaac's.
TEST(UrdfJoints, WithoutARangeMoveFreelyUnlessTheyAreToBeWelds) {
  ImportFileOptions welds;
  welds.welds_locked = true;
  for (const char* type : {"revolute", "prismatic"}) {
    for (const char* limit : {"effort='10' velocity='2'", "lower='0' upper='0' effort='10'",
                              "lower='0' velocity='2'", ""}) {
      const auto free = limits_of(type, limit);
      ASSERT_TRUE(free) << type << limit;
      EXPECT_EQ(free->position_min, -INFINITY) << limit;
      EXPECT_EQ(free->position_max, INFINITY) << limit;
      EXPECT_FALSE(limits_of(type, limit, welds)) << limit;
    }
    EXPECT_FALSE(limits_of(type, "lower='0' upper='0'"));
    EXPECT_FALSE(limits_of(type, "lower='0.3' upper='0.3' effort='10' velocity='2'"));
  }
  EXPECT_EQ(limits_of("revolute", "effort='10'")->effort_max, 10);
  const std::string said =
      all_of(urdf(kArm + "<joint name='j' type='revolute'>" + kEnds + "<limit effort='1'/></joint>")
                 .notes);
  EXPECT_NE(said.find("joints without a range"), std::string::npos) << said;
  EXPECT_NE(said.find("--weld-locked holds them at zero): j\n"), std::string::npos) << said;
}

// Oracle: a range of half a turn, written in degrees; ranges of arms, slides and of none.
TEST(UrdfJoints, WhoseRangeSeemsInDegreesAreAskedAbout) {
  const auto is_asked = [](const std::string& type, const std::string& end) {
    const std::string limit = "<limit lower='-" + end + "' upper='" + end + "'/>";
    const std::string notes = all_of(
        urdf(kArm + "<joint name='j' type='" + type + "'>" + kEnds + limit + "</joint>").notes);
    return notes.find("28.6 turns: degrees?") != std::string::npos;
  };
  EXPECT_TRUE(is_asked("revolute", "90"));
  EXPECT_FALSE(is_asked("prismatic", "90"));
  for (const char* end : {"3.14", "6.2832", "10000", "3.4e38"}) {
    EXPECT_FALSE(is_asked("revolute", end)) << end;
  }
}

// Oracle: the schema's bounds, just inside and just outside.
TEST(UrdfJoints, WhoseLimitsNoDocumentHoldsHaveNone) {
  const auto ends = [](const std::string& lower, const std::string& upper) {
    return *limits_of("revolute", "lower='" + lower + "' upper='" + upper + "'");
  };
  EXPECT_EQ(ends("-1e6", "1e6").position_max, INFINITY);
  EXPECT_EQ(ends("-inf", "inf").position_min, -INFINITY);
  EXPECT_EQ(ends("-3.4028235e+38", "3.4028235e+38").position_max, INFINITY);
  EXPECT_EQ(ends("-25.13", "25.13").position_max, 25.13);  // four turns
  EXPECT_EQ(ends("-9999", "9999").position_max, 9999);
  EXPECT_EQ(ends("-1", "1e9").position_min, -1);
  EXPECT_EQ(ends("-1", "1e9").position_max, 1e4);
  const auto bounds = [](const std::string& type, const std::string& more) {
    return *limits_of(type, "lower='-1' upper='1' " + more);
  };
  EXPECT_EQ(bounds("revolute", "effort='1e9' velocity='inf'").effort_max, INFINITY);
  EXPECT_EQ(bounds("revolute", "effort='1e9' velocity='1e30'").speed_max, INFINITY);
  EXPECT_EQ(bounds("revolute", "effort='1e6' velocity='1e5'").effort_max, 1e6);
  EXPECT_EQ(bounds("revolute", "effort='1e6' velocity='1e5'").speed_max, 1e5);
  EXPECT_EQ(bounds("prismatic", "effort='1e7' velocity='1e4'").effort_max, 1e7);
  EXPECT_EQ(bounds("prismatic", "effort='1.1e7' velocity='1.1e4'").speed_max, INFINITY);
  const std::string said =
      all_of(urdf(kArm + "<joint name='j' type='revolute'>" + kEnds +
                  "<limit lower='-1e6' upper='1e6' effort='1e10' velocity='3'/></joint>")
                 .notes);
  EXPECT_NE(said.find("2 limits greater than any that a document holds are left out: they say that "
                      "there is none: j\n"),
            std::string::npos)
      << said;
  for (const char* wrong : {"nan", "1 2", "much"}) {
    const std::string refused = refusal([&] { return ends("0", wrong); });
    EXPECT_NE(refused.find("must be 1 number, or inf"), std::string::npos) << refused;
  }
  EXPECT_NE(refusal([&] { return ends("inf", "inf"); }).find("is not below"), std::string::npos);
}

// Oracle: readers of the format take a limit of zero for no force; and our own import.
TEST(UrdfJoints, OfUnknownLimitsAreWrittenAsUnlimited) {
  const Robot robot = urdf(kArm + "<joint name='j' type='continuous'>" + kEnds + "</joint>").robot;
  const Exported written = urdf_of(robot);
  EXPECT_EQ(written.text.find("effort=\"0\""), std::string::npos) << written.text;
  EXPECT_EQ(written.text.find("velocity=\"0\""), std::string::npos) << written.text;
  EXPECT_NE(written.text.find("effort=\"1000000000\""), std::string::npos) << written.text;
  EXPECT_NE(all_of(written.notes).find("effort or velocity of 1 joint is not known"),
            std::string::npos);
  const test::ScratchFolder folder;
  const Imported back = read_urdf(folder.write("back.urdf", written.text));
  EXPECT_EQ(back.robot.tree.bodies[1].joint.limits.effort_max, INFINITY);
  EXPECT_EQ(back.robot.tree.bodies[1].joint.limits.speed_max, INFINITY);
}

// The format demands a range of what slides; ours comes back as none.
TEST(UrdfJoints, ThatSlideWithoutARangeComeBackWithoutOne) {
  const Robot robot = urdf(kArm + "<joint name='j' type='prismatic'>" + kEnds + "</joint>").robot;
  const test::ScratchFolder folder;
  const Imported back = read_urdf(folder.write("back.urdf", urdf_of(robot).text));
  EXPECT_EQ(back.robot.tree.bodies[1].joint.limits.position_max, INFINITY);
}

TEST(UrdfJoints, ThatFloatOnAnEmptyRootFreeTheBase) {
  const Imported read = urdf(
      kArm + "<joint name='j' type='floating'><parent link='world'/><child link='a'/></joint>");
  EXPECT_EQ(read.robot.tree.base, dynamics::BaseKind::kSpatial);
  ASSERT_EQ(read.robot.tree.bodies.size(), 1u);
  EXPECT_EQ(read.robot.tree.bodies[0].name, "a");
}

std::string plate(const std::string& moments) {
  return "<link name='a'><inertial><mass value='1'/><inertia " + moments +
         " ixy='-5e-20' ixz='0' iyz='0'/></inertial></link>";
}

TEST(Inertias, ThatRoundingSpoiltAreMendedWhereThatIsAskedFor) {
  const std::string flat = plate("ixx='0.011' iyy='0.024' izz='0.036'");
  EXPECT_NE(refusal([&] { return urdf(flat); }).find("--mend-inertias"), std::string::npos);
  const Imported read = urdf(flat, kMends);
  EXPECT_NE(all_of(read.notes).find("mended"), std::string::npos);
  // The nearest: a third of what is too much, each.
  const Eigen::Matrix3d& inertia = read.robot.tree.bodies[0].inertia.inertia_kg_m2;
  EXPECT_NEAR(inertia(0, 0), 0.011 + 0.001 / 3, 1e-9);
  EXPECT_NEAR(inertia(2, 2), 0.036 - 0.001 / 3, 1e-9);
}

// Oracle: the nearest point of the plane "largest = sum of the others", by hand: a third of what is
// too much, each.
TEST(Inertias, ThatNoRoundingExplainsAreMendedToo) {
  // Three moments off by half a unit of their last place each explain 0.0015, not 0.002.
  const std::string wrong = plate("ixx='0.011' iyy='0.024' izz='0.037'");
  const std::string change =
      "principal moments 0.011, 0.024, 0.037 kg m2 become 0.0116667, 0.0246667, 0.0363333";
  const std::string refused = refusal([&] { return urdf(wrong); });
  EXPECT_NE(refused.find("no rigid body"), std::string::npos) << refused;
  EXPECT_NE(refused.find("--mend-inertias takes the nearest flat body: of \"a\" " + change),
            std::string::npos)
      << refused;
  const Imported read = urdf(wrong, kMends);
  EXPECT_NEAR(read.robot.tree.bodies[0].inertia.inertia_kg_m2(2, 2), 0.037 - 0.002 / 3, 1e-9);
  const std::string said = all_of(read.notes);
  EXPECT_NE(said.find("that no rounding explains"), std::string::npos) << said;
  EXPECT_NE(said.find("a (" + change + ")"), std::string::npos) << said;
  // A negative moment is no missed inequality.
  const std::string negative = plate("ixx='-0.011' iyy='0.024' izz='0.037'");
  for (const ImportFileOptions& options : {ImportFileOptions(), kMends}) {
    const std::string none = refusal([&] { return urdf(negative, options); });
    EXPECT_NE(none.find("must be positive"), std::string::npos) << none;
    EXPECT_EQ(none.find("--mend-inertias"), std::string::npos) << none;
  }
}

// Oracle: Bullet, to which a root of mass 0 stands fixed; MuJoCo refuses a floating body without
// mass.
TEST(Inertias, AreNeededOfAFloatingBase) {
  const std::string joint =
      "<joint name='j' type='continuous'><parent link='base'/><child link='a'/></joint>";
  const std::string arm = "<link name='a'>" + kUnit + "</link>" + joint;
  const Imported fixed = urdf("<link name='base'/>" + arm);
  EXPECT_EQ(fixed.robot.tree.base, dynamics::BaseKind::kFixed);
  EXPECT_NE(all_of(fixed.notes).find("\"base\" stands fixed, for it has no mass"),
            std::string::npos);
  const std::string welded = "<link name='trunk'>" + kUnit +
                             "</link><joint name='k' type='fixed'><parent link='base'/>"
                             "<child link='trunk'/></joint>";
  EXPECT_EQ(urdf("<link name='base'/>" + arm + welded).robot.tree.base,
            dynamics::BaseKind::kSpatial);
  const std::string said = refusal([&] {
    return urdf(
        "<link name='world'/><link name='base'/>" + arm +
        "<joint name='k' type='floating'><parent link='world'/><child link='base'/></joint>");
  });
  EXPECT_NE(said.find("<link name=\"base\">: body \"base\": has no mass, and floats"),
            std::string::npos)
      << said;
}

TEST(Inertias, RoundAsTheyAreWritten) {
  EXPECT_EQ(rounding_of("0.012 0.5"), 0.05);
  EXPECT_NEAR(rounding_of("1.25e-3"), 0.5e-5, 1e-20);
  EXPECT_EQ(rounding_of("3 0 0.0"), 0);
}

}  // namespace
}  // namespace torquewright::hopper
