// SPDX-License-Identifier: Apache-2.0
// Oracle of the round trips: the dynamics of the robot that was written.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/parts/rotations.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/same_robot.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using Eigen::Vector3d;
using test::dynamic_difference;

constexpr double kSame = 1e-11;  // rotations by angles and back, some hundreds of roundings

Imported imported_urdf(const std::string& text) {
  const test::ScratchFolder folder;
  return read_urdf(folder.write("robot.urdf", text));
}
Imported imported_mjcf(const std::string& text) {
  const test::ScratchFolder folder;
  return read_mjcf(folder.write("robot.xml", text));
}

class RobotFiles : public testing::TestWithParam<int> {
 protected:
  static Robot drawn(int seed) {
    oracles::Dice dice(static_cast<std::uint64_t>(seed));
    return test::random_robot(dice, static_cast<BaseKind>(seed % 3));
  }
  Robot robot = drawn(GetParam());
};

TEST_P(RobotFiles, ComeBackFromUrdf) {
  if (robot.tree.base == BaseKind::kPlanar) robot.tree.base = BaseKind::kSpatial;
  const Robot back = imported_urdf(urdf_of(robot).text).robot;
  EXPECT_LE(dynamic_difference(robot, back), kSame);
  EXPECT_EQ(back.name, robot.name);
  for (const dynamics::Body& body : robot.tree.bodies) {
    if (!std::isfinite(body.joint.limits.effort_max)) continue;
    const dynamics::Joint& joint = back.tree.bodies[*back.find_joint(body.joint.name)].joint;
    EXPECT_EQ(joint.limits.position_min, body.joint.limits.position_min);
    EXPECT_EQ(joint.limits.position_max, body.joint.limits.position_max);
    EXPECT_EQ(joint.limits.speed_max, body.joint.limits.speed_max);
    EXPECT_EQ(joint.limits.effort_max, body.joint.limits.effort_max);
  }
}

TEST_P(RobotFiles, ComeBackFromMjcf) {
  const Robot back = imported_mjcf(mjcf_of(robot).text).robot;
  EXPECT_LE(dynamic_difference(robot, back), kSame);
  for (const dynamics::Body& body : robot.tree.bodies) {
    if (!std::isfinite(body.joint.limits.effort_max)) continue;
    const dynamics::Joint& joint = back.tree.bodies[*back.find_joint(body.joint.name)].joint;
    EXPECT_EQ(joint.limits.position_max, body.joint.limits.position_max);
  }
}

TEST_P(RobotFiles, ComeBackFromDocuments) {
  for (dynamics::Body& body : robot.tree.bodies) body.joint.rotor_spin_kg_m2 = {0.01, 0.02, 0};
  const test::ScratchFolder folder;
  const Robot back = read_robot(folder.write("robot.json", robot_json(robot).dump())).robot;
  EXPECT_LE(dynamic_difference(robot, back), kSame);
  EXPECT_EQ(back.contacts[0].restitution, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RobotFiles, testing::Range(0, 15));

// Oracle: two masses on a rod, their common centre and Steiner's theorem.
TEST(Urdf, WeldsFixedLinksIntoTheirParents) {
  const Imported read = imported_urdf(R"(<robot name="r"><link name="base_link"/>
    <link name="a"><inertial><mass value="2"/><origin xyz="1 0 0"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <link name="b"><inertial><mass value="6"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <joint name="w" type="fixed"><parent link="base_link"/><child link="a"/></joint>
    <joint name="x" type="fixed"><parent link="a"/><child link="b"/><origin xyz="-1 0 0"/></joint>
    </robot>)");
  ASSERT_EQ(read.robot.tree.bodies.size(), 1u);
  const dynamics::RigidInertia& whole = read.robot.tree.bodies[0].inertia;
  EXPECT_EQ(whole.mass_kg, 8);
  EXPECT_LE((whole.center_of_mass_m - Vector3d(-0.5, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(whole.inertia_kg_m2(0, 0), 2, 1e-15);
  EXPECT_NEAR(whole.inertia_kg_m2(1, 1), 2 + 2 * 6.0 / 8 * 4, 1e-14);
}

// Oracle: N^2 J.
TEST(Urdf, ReadsRotorsOfTransmissions) {
  const Imported read = imported_urdf(R"(<robot name="r"><link name="world"/>
    <link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
    <joint name="j" type="continuous"><parent link="world"/><child link="a"/>
      <dynamics damping="0.1" friction="0.3"/></joint>
    <transmission><joint name="j"/><actuator name="m"><drake:rotor_inertia value="0.0002"/>
      <drake:gear_ratio value="8"/></actuator></transmission></robot>)");
  EXPECT_EQ(read.robot.tree.base, BaseKind::kFixed);
  EXPECT_NEAR(read.robot.tree.bodies[1].joint.reflected_inertia, 0.0128, 1e-17);
  EXPECT_EQ(read.robot.tree.bodies[1].joint.axis, Vector3d(1, 0, 0));
  EXPECT_EQ(read.robot.tree.bodies[1].joint.passive.damping, 0.1);
  EXPECT_EQ(read.robot.tree.bodies[1].joint.passive.dry_friction, 0.3);
  EXPECT_TRUE(read.notes.empty());
}

// Oracle: RaiSim's word, which stands at the joint.
TEST(Urdf, ReadsTheRotorInertiaOfDynamics) {
  const std::string arm = R"(<robot name="r"><link name="world"/>
    <link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
    <joint name="j" type="continuous"><parent link="world"/><child link="a"/>
      <dynamics damping="0" rotor_inertia="0.09"/></joint>)";
  const Imported read = imported_urdf(arm + "</robot>");
  EXPECT_EQ(read.robot.tree.bodies[1].joint.reflected_inertia, 0.09);
  EXPECT_TRUE(read.notes.empty());
  EXPECT_THROW(imported_urdf(arm + R"(<transmission><joint name="j"/><actuator name="m">
    <drake:rotor_inertia value="0.0002"/></actuator></transmission></robot>)"),
               io::SpecError);
}

TEST(Mjcf, TakesDefaultsDegreesAndJointsAwayFromTheBodysOrigin) {
  const Imported read = imported_mjcf(R"(<mujoco><default><joint armature="0.1"/>
    <default class="leg"><joint range="-90 45" axis="0 1 0"/></default></default>
    <worldbody><body name="a" childclass="leg"><freejoint/>
      <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
      <body name="b" pos="0 0 -1"><joint name="j" pos="0 0 0.25"/>
        <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
        <body name="c" pos="0 0 -1"><joint name="k" type="slide" armature="0.5" range="0 1"/>
          <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></body></body>
    </worldbody></mujoco>)");
  const auto& bodies = read.robot.tree.bodies;
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[1].joint.reflected_inertia, 0.1);
  EXPECT_NEAR(bodies[1].joint.limits.position_min, -M_PI / 2, 1e-15);
  EXPECT_EQ(bodies[1].joint.axis, Vector3d(0, 1, 0));
  EXPECT_EQ(bodies[1].joint.p_PB_m.z(), -0.75);
  EXPECT_EQ(bodies[1].inertia.center_of_mass_m.z(), -0.25);
  EXPECT_EQ(bodies[2].joint.p_PB_m.z(), -1.25);
  EXPECT_EQ(bodies[2].joint.limits.position_max, 1);
  EXPECT_EQ(bodies[2].joint.reflected_inertia, 0.5);
}

struct BadFile {
  bool is_urdf;
  const char* text;
  const char* message;
};

TEST(RobotFile, SaysWhatIsWrong) {
  const std::vector<BadFile> files{
      {true, "", "no XML"},
      {true, "<robot><link", "no XML"},
      {true, "<mujoco/>", "must hold <robot>"},
      {true, "<robot/>", "no link"},
      {true, "<!DOCTYPE r [<!ENTITY e SYSTEM \"/etc/hostname\">]><robot><link name=\"a\"/></robot>",
       "entities"},
      {true, "<robot xmlns:xacro='x'><xacro:include filename='/etc/hostname'/></robot>", "xacro"},
      {true,
       "<robot><link name='a'/><link name='b'/><joint name='j' type='fixed'><parent link='a'/>"
       "<child link='bb'/></joint></robot>",
       "did you mean \"b\""},
      {true,
       "<robot><link name='a'/><link name='b'/><joint name='j' type='fixed'><parent link='a'/>"
       "<child link='b'/></joint><joint name='k' type='fixed'><parent link='a'/>"
       "<child link='b'/></joint></robot>",
       "closed loop"},
      {true,
       "<robot><link name='a'/><link name='b'/><joint name='j' type='revolute'><parent link='a'/>"
       "<child link='b'/><limit lower='2' upper='1'/></joint></robot>",
       "not below"},
      {true,
       "<robot><link name='a'><inertial><mass value='1e400'/><inertia/></inertial></link>"
       "</robot>",
       "must be 1 number"},
      {false, "<mujoco><include file='/etc/hostname'/></mujoco>", "relative path"},
      {false, "<mujoco><worldbody/></mujoco>", "holds no body"},
      {false, "<mujoco><worldbody><body><geom/></body></worldbody></mujoco>", "sizes are missing"},
      {false,
       "<mujoco><worldbody><body><inertial mass='1' pos='nan 0 0'/></body></worldbody></mujoco>",
       "must be 3 numbers"},
      {false,
       "<mujoco><worldbody><body><joint type='ball' armature='1'/><inertial "
       "mass='1'/></body></worldbody>"
       "</mujoco>",
       "hinge or slide"},
      {false,
       "<mujoco><worldbody><body><inertial mass='1'/></body></worldbody><equality><connect/>"
       "</equality></mujoco>",
       "closes a loop"}};
  for (const BadFile& bad : files) {
    try {
      (void)(bad.is_urdf ? imported_urdf(bad.text) : imported_mjcf(bad.text));
      ADD_FAILURE() << "was read: " << bad.text;
    } catch (const io::SpecError& error) {
      EXPECT_NE(std::string(error.what()).find(bad.message), std::string::npos) << bad.text << "\n"
                                                                                << error.what();
    }
  }
}

const std::string kWithInertia = R"(<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>)";

/// What the document of a robot with one joint says of its rotor: "absent", or the number.
std::string rotor_key(const Robot& robot) {
  const nlohmann::ordered_json joint = robot_json(robot)["joints"][0];
  return joint.contains("reflected_inertia_kg_m2") ? joint["reflected_inertia_kg_m2"].dump()
                                                   : "absent";
}

// Oracle: the file's own words. What a joint states stands in the place of its actuator's rotor, so
// that a number which no file said would take the rotor away.
TEST(RobotFile, SaysOfRotorsWhatItStatesAndNoMore) {
  const auto one_joint = [](const std::string& joint) {
    return imported_mjcf("<mujoco><worldbody><body name='a'>" + kWithInertia +
                         "<body name='b'><joint name='j' " + joint + "/>" + kWithInertia +
                         "</body></body></worldbody></mujoco>")
        .robot;
  };
  EXPECT_EQ(rotor_key(one_joint("")), "absent");
  EXPECT_EQ(rotor_key(one_joint("armature='0'")), "0.0");
  EXPECT_EQ(rotor_key(one_joint("armature='0.25'")), "0.25");
  const auto urdf = [](const std::string& transmission) {
    return imported_urdf(R"(<robot name="r"><link name="world"/><link name="a"><inertial>
      <mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
      <joint name="j" type="continuous"><parent link="world"/><child link="a"/></joint>)" +
                         transmission + "</robot>")
        .robot;
  };
  EXPECT_EQ(rotor_key(urdf("")), "absent");
  EXPECT_EQ(rotor_key(urdf(R"(<transmission><joint name="j"/><actuator name="m">
      <drake:rotor_inertia value="0"/></actuator></transmission>)")),
            "0.0");
  // Out and in again, by every format.
  for (const char* stated : {"", "armature='0'", "armature='0.25'"}) {
    const Robot robot = one_joint(stated);
    const test::ScratchFolder folder;
    const auto file = folder.write("robot.json", robot_json(robot).dump());
    EXPECT_EQ(rotor_key(read_robot(file).robot), rotor_key(robot));
    EXPECT_EQ(rotor_key(imported_mjcf(mjcf_of(robot).text).robot), rotor_key(robot));
    EXPECT_EQ(rotor_key(imported_urdf(urdf_of(robot).text).robot), rotor_key(robot));
  }
}

// Oracle: N^2 J by hand, of an actuator with gears of 6 and a rotor of 6.3e-5 kg m2.
TEST(RobotFile, LeavesRotorsToTheActuatorThatIsAdded) {
  const Robot bare = imported_mjcf("<mujoco><worldbody><body name='a'>" + kWithInertia +
                                   "<body name='b'><joint name='j'/>" + kWithInertia +
                                   "</body></body></worldbody></mujoco>")
                         .robot;
  nlohmann::ordered_json document = robot_json(bare);
  const char* const drive = TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/mini_cheetah_hip.json";
  document["mechanisms"] = {{{"type", "direct"}, {"joints", {"j"}}, {"actuators", {drive}}}};
  const test::ScratchFolder folder;
  const Robot driven = read_robot(folder.write("robot.json", document.dump())).robot;
  EXPECT_NEAR(driven.tree.bodies[1].joint.reflected_inertia, 36 * 6.3e-5, 1e-17);
}

// Oracle: the inverse is one, also where pitch is upright or, as files print it, nearly so.
TEST(Rotations, AreThoseOfTheirAngles) {
  constexpr double kRoundings = 3e-15;  // of nine entries, some products each
  oracles::Dice dice(4);
  for (int i = 0; i < 1000; ++i) {
    const double turn = test::uniform(dice, -3, 3);
    for (const double pitch : {M_PI / 2, 1.57079632679, 1.5708, 1.57, -1.570796, -M_PI / 2}) {
      const Eigen::Matrix3d R = rotation_of_rpy({turn, pitch, 0.4});
      EXPECT_LE((rotation_of_rpy(rpy_of_rotation(R)) - R).norm(), kRoundings) << pitch;
    }
    const Eigen::Matrix3d R = test::random_rotation(dice);
    EXPECT_LE((rotation_of_rpy(rpy_of_rotation(R)) - R).norm(), kRoundings);
  }
}

}  // namespace
}  // namespace torquewright::hopper
