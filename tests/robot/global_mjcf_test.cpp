// SPDX-License-Identifier: Apache-2.0
// Old and unusual MJCF: global coordinates, gravity that leans a little, balls, blank names.
// Oracles: the same robot written in local coordinates by hand, three hinges written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "robot/mjcf/mjcf_reader.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/imported_notes.hpp"
#include "tests/robot/same_robot.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kSameMotion = 1e-11;  // roundings of some ten products of rotations

Imported read_mujoco(const std::string& text) {
  const test::ScratchFolder folder;
  return read_mjcf(folder.write("robot.xml", text));
}

std::string refused(const std::string& text) {
  return test::refusal([&] { return read_mujoco(text); });
}

/// A leg as Gym's hopper has it, with a calf that is turned by a right angle about y, and a mass
/// that is stated.
const std::string kGlobal = R"(<mujoco><compiler coordinate="global"/><worldbody>
<body name="torso" pos="0 0 1.25">
 <joint name="x" type="slide" axis="1 0 0" pos="0 0 0"/>
 <joint name="z" type="slide" axis="0 0 1" pos="0 0 0" ref="1.25"/>
 <joint name="pitch" axis="0 1 0" pos="0 0 1.25"/>
 <geom type="capsule" fromto="0 0 1.45 0 0 1.05" size="0.05"/>
 <body name="thigh" pos="0.5 0 1.05">
  <joint name="hip" axis="0 -1 0" pos="0 0 1.05" range="-150 0"/>
  <geom type="capsule" fromto="0 0 1.05 0 0 0.6" size="0.05"/>
  <body name="calf" pos="0 0 0.35" quat="1 0 1 0">
   <joint name="knee" axis="0 -0.6 0.8" pos="0 0 0.6"/>
   <geom type="box" pos="0.1 0 0.3" size="0.1 0.2 0.3" euler="0 0 30"/>
   <body name="foot" pos="0.13 0 0" axisangle="0 0 1 90">
    <joint name="ankle" axis="0 -1 0" pos="0 0 0.1" ref="20"/>
    <inertial pos="0.2 0.1 0.1" mass="2" diaginertia="0.1 0.2 0.25" euler="10 0 0"/>
   </body>
  </body>
 </body>
</body></worldbody></mujoco>)";

// By hand. The calf's x is the world's -z, its z the world's x; the foot's x is the world's y.
// In the calf: (x, y, z) of the world from its origin is (-z, y, x). In the foot: (y, -x, z).
const std::string kLocal = R"(<mujoco><worldbody>
<body name="torso" pos="0 0 1.25">
 <joint name="x" type="slide" axis="1 0 0" pos="0 0 -1.25"/>
 <joint name="z" type="slide" axis="0 0 1" pos="0 0 -1.25" ref="1.25"/>
 <joint name="pitch" axis="0 1 0"/>
 <geom type="capsule" fromto="0 0 0.2 0 0 -0.2" size="0.05"/>
 <body name="thigh" pos="0.5 0 -0.2">
  <joint name="hip" axis="0 -1 0" pos="-0.5 0 0" range="-150 0"/>
  <geom type="capsule" fromto="-0.5 0 0 -0.5 0 -0.45" size="0.05"/>
  <body name="calf" pos="-0.5 0 -0.7" xyaxes="0 0 -1 0 1 0">
   <joint name="knee" axis="-0.8 -0.6 0" pos="-0.25 0 0"/>
   <geom type="box" pos="0.05 0 0.1" size="0.1 0.2 0.3"
    xyaxes="0 0.5 0.8660254037844386 0 0.8660254037844386 -0.5"/>
   <body name="foot" pos="0.35 0 0.13" xyaxes="0 1 0 0 0 -1">
    <joint name="ankle" axis="-1 0 0" pos="0 0.13 0.1" ref="20"/>
    <inertial pos="0.1 -0.07 0.1" mass="2" diaginertia="0.1 0.2 0.25"
     xyaxes="0 -1 0 0.984807753012208 0 0.17364817766693033"/>
   </body>
  </body>
 </body>
</body></worldbody></mujoco>)";

TEST(GlobalCoordinates, AreTheSameRobotAsLocalOnes) {
  const Robot global = read_mujoco(kGlobal).robot;
  const Robot local = read_mujoco(kLocal).robot;
  EXPECT_LE(test::dynamic_difference(global, local), kSameMotion);
}

TEST(GlobalCoordinates, NeedNoPlaceOfABodyThatJointsCarry) {
  std::string placeless = kGlobal;
  placeless.erase(placeless.find(R"( pos="0.5 0 1.05")"), 17);
  placeless.erase(placeless.find(R"( pos="0 0 1.25">)"), 15);
  EXPECT_LE(test::dynamic_difference(read_mujoco(placeless).robot, read_mujoco(kLocal).robot),
            kSameMotion);
}

TEST(GlobalCoordinates, AreRefusedWhereTheySayTooLittle) {
  const auto with = [](const std::string& body) {
    return refused("<mujoco><compiler coordinate='global'/><worldbody>" + body +
                   "</worldbody></mujoco>");
  };
  EXPECT_NE(with("<body name='a'><freejoint/><geom size='1'/></body>").find("needs a pos"),
            std::string::npos);
  EXPECT_EQ(with("<body name='a' pos='0 0 1'><freejoint/><geom size='1'/></body>"), "was read");
  EXPECT_NE(with("<body name='a' pos='0 0 1'><frame><geom size='1'/></frame></body>")
                .find("know no frames"),
            std::string::npos);
  EXPECT_NE(refused("<mujoco><compiler coordinate='polar'/></mujoco>").find("local, global"),
            std::string::npos);
}

TEST(Gravity, LeansALittleAndIsSaid) {
  const auto with = [](const std::string& gravity) {
    return "<mujoco><option gravity='" + gravity +
           "'/><worldbody><body name='a'><freejoint/><geom size='1'/></body></worldbody></mujoco>";
  };
  const Imported read = read_mujoco(with("0.0098 0 -9.81"));
  EXPECT_EQ(read.robot.tree.gravity_m_s2, 9.81);
  EXPECT_NE(test::all_of(read.notes).find("tilted by 0.001 rad"), std::string::npos);
  EXPECT_EQ(test::all_of(read_mujoco(with("0 0 -9.81")).notes).find("tilted"), std::string::npos);
  for (const char* gravity : {"0 0.0099 -9.81", "0 0 9.81", "1e-5 0 0"}) {
    EXPECT_NE(refused(with(gravity)).find("along -z"), std::string::npos) << gravity;
  }
}

std::string pendulum(const std::string& joints) {
  return "<mujoco><worldbody><body name='a'><freejoint/><geom size='1'/><body name='b' pos='0 0 1' "
         "euler='10 20 30'>" +
         joints + "<geom type='box' size='1 2 3'/></body></body></worldbody></mujoco>";
}

TEST(BallJoints, AreThreeHinges) {
  const Imported ball = read_mujoco(pendulum("<joint name='j' type='ball' pos='0 0.5 0'/>"));
  const Robot hinges =
      read_mujoco(
          pendulum("<joint name='j' axis='1 0 0' pos='0 0.5 0'/><joint name='j.y' axis='0 1 0' "
                   "pos='0 0.5 0'/><joint name='j.z' axis='0 0 1' pos='0 0.5 0'/>"))
          .robot;
  EXPECT_LE(test::dynamic_difference(ball.robot, hinges), kSameMotion);
  EXPECT_NE(test::all_of(ball.notes).find("ball joints are hinges about x, y and z here"),
            std::string::npos);
  for (const char* more : {"armature='0.1'", "range='0 60'"}) {
    const std::string said =
        refused(pendulum("<joint name='j' type='ball' " + std::string(more) + "/>"));
    EXPECT_NE(said.find("type \"ball\""), std::string::npos) << said;
  }
}

TEST(Names, ThatAreBlankAreMadeUpAndSaid) {
  const Imported read = read_mujoco(
      "<mujoco model=' '><worldbody><body name='a'><freejoint/><geom size='1'/>"
      "<body name=' '><joint name=''/><geom size='1'/></body></body></worldbody></mujoco>");
  EXPECT_EQ(read.robot.name, "robot");
  EXPECT_EQ(read.robot.tree.bodies[1].name, "body_1");
  EXPECT_EQ(read.robot.tree.bodies[1].joint.name, "joint_1");
  EXPECT_NE(test::all_of(read.notes).find("states none: body_1, joint_1"), std::string::npos)
      << test::all_of(read.notes);
}

}  // namespace
}  // namespace torquewright::hopper
