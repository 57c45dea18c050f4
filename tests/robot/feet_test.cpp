// SPDX-License-Identifier: Apache-2.0
// What an imported robot stands on. Oracles: corners and ends of shapes by hand, names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/faults/spec_error.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/imported_notes.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

const std::string kLinkMass =
    "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";

/// A trunk, and on it links of these names with these collisions; `more` in the first one's joint.
Imported standing(const std::vector<std::array<std::string, 2>>& links,
                  const std::string& more = "") {
  std::string text = "<robot name='r'><link name='trunk'>" + kLinkMass + "</link>";
  for (const auto& [name, shapes] : links) {
    text += "<link name='" + name + "'>" + kLinkMass + shapes + "</link><joint name='to_" + name +
            "' type='continuous'><parent link='trunk'/><child link='" + name + "'/>" + more +
            "</joint>";
  }
  const test::ScratchFolder folder;
  return read_urdf(folder.write("r.urdf", text + "</robot>"));
}

std::string shape(const std::string& geometry, const std::string& origin = "") {
  return "<collision>" + origin + "<geometry>" + geometry + "</geometry></collision>";
}

/// Whether the contacts are these points and no others, in any order.
void expect_points(const Robot& robot, const std::vector<Vector3d>& points, double radius_m) {
  ASSERT_EQ(robot.contacts.size(), points.size());
  for (const Vector3d& point : points) {
    const auto is_there = [&](const ContactPoint& contact) {
      return (contact.point.p_B_m - point).norm() < 1e-14 && contact.radius_m == radius_m;
    };
    EXPECT_TRUE(std::any_of(robot.contacts.begin(), robot.contacts.end(), is_there))
        << point.transpose();
  }
}

const std::string kSole = shape("<box size='0.2 0.1 0.04'/>", "<origin xyz='0.03 0 -0.05'/>");

TEST(Feet, OfBoxesAreTheirLowerCorners) {
  const Imported read = standing({{{"left_foot", kSole}}});
  expect_points(
      read.robot,
      {{0.13, 0.05, -0.07}, {0.13, -0.05, -0.07}, {-0.07, 0.05, -0.07}, {-0.07, -0.05, -0.07}}, 0);
  EXPECT_EQ(read.robot.contacts[0].friction_coefficient, 0.8);
  EXPECT_EQ(read.robot.assumed.size(), 4u);
  EXPECT_NE(test::all_of(read.notes).find("taken from shapes that collide: 4 of left_foot\n"),
            std::string::npos)
      << test::all_of(read.notes);
}

// Turned over by its joint, the box stands on its other side.
TEST(Feet, AreLowWhereAllJointsAreAtZero) {
  const Imported read = standing({{{"left_foot", kSole}}}, "<origin rpy='3.141592653589793 0 0'/>");
  expect_points(
      read.robot,
      {{0.13, 0.05, -0.03}, {0.13, -0.05, -0.03}, {-0.07, 0.05, -0.03}, {-0.07, -0.05, -0.03}}, 0);
}

TEST(Feet, OfRoundShapesAreBallsOrARim) {
  const std::string lying = "<origin xyz='0 0 -0.1' rpy='1.5707963267948966 0 0'/>";
  for (const char* word : {"capsule", "cylinder"}) {
    const std::string geometry = "<" + std::string(word) + " radius='0.02' length='0.1'/>";
    expect_points(standing({{{"toe", shape(geometry, lying)}}}).robot,
                  {{0, 0.05, -0.1}, {0, -0.05, -0.1}}, 0.02);
  }
  expect_points(standing({{{"toe", shape("<cylinder radius='0.02' length='0.1'/>")}}}).robot,
                {{0.02, 0, -0.05}, {-0.02, 0, -0.05}, {0, 0.02, -0.05}, {0, -0.02, -0.05}}, 0);
}

TEST(Feet, OfMjcfAreTheSameWithTheGeomsFriction) {
  const test::ScratchFolder folder;
  const Imported read = read_mjcf(folder.write(
      "r.xml",
      "<mujoco><worldbody><body name='a'><freejoint/><geom size='1'/><body name='shin'><joint/>"
      "<geom name='bar' type='capsule' size='0.02' fromto='0 0 0 0 0 -0.3' friction='0.5'/>"
      "<geom type='box' size='1 1 1' contype='0' conaffinity='0'/></body></body></worldbody>"
      "</mujoco>"));
  expect_points(read.robot, {{0, 0, 0}, {0, 0, -0.3}}, 0.02);
  EXPECT_EQ(read.robot.contacts[0].friction_coefficient, 0.5);
  EXPECT_EQ(read.robot.contacts[1].name, "bar_2");
}

std::vector<std::string> bodies_of(const Imported& read) {
  std::vector<std::string> names;
  for (const ContactPoint& contact : read.robot.contacts) {
    names.push_back(read.robot.tree.bodies[contact.point.body].name);
  }
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

// A head, a hand and a sensor are no feet; what is called a foot is one, whatever it carries.
TEST(Feet, AreNotTheOtherLeaves) {
  const std::string ball = shape("<sphere radius='0.02'/>");
  const std::string box = shape("<box size='1 1 1'/>");
  const Imported read = standing({{{"Head", ball}},
                                  {{"left_hand", ball}},
                                  {{"imu_link", box}},
                                  {{"front_camera", box}},
                                  {{"forearm", ball}},
                                  {{"calf", ball + box}}});
  EXPECT_EQ(bodies_of(read), std::vector<std::string>{"calf"});
  EXPECT_EQ(read.robot.contacts.size(), 1u);  // its ball, not its box
}

TEST(Feet, ThatCarryAnotherAreFeetByTheirName) {
  const std::string ball = shape("<sphere radius='0.02'/>");
  const auto chain = [&](const std::string& upper, const std::string& lower) {
    const test::ScratchFolder folder;
    return bodies_of(read_urdf(folder.write(
        "r.urdf",
        "<robot name='r'><link name='trunk'>" + kLinkMass + "</link><link name='" + upper + "'>" +
            kLinkMass + ball + "</link><link name='" + lower + "'>" + kLinkMass + ball +
            "</link><joint name='j' type='continuous'><parent link='trunk'/><child link='" + upper +
            "'/></joint><joint name='k' type='continuous'><parent link='" + upper +
            "'/><child link='" + lower + "'/></joint></robot>")));
  };
  EXPECT_EQ(chain("sole", "lidar"), std::vector<std::string>{"sole"});
  EXPECT_EQ(chain("ankle_pitch", "foot"), std::vector<std::string>{"foot"});
  EXPECT_EQ(chain("thigh", "calf"), std::vector<std::string>{"calf"});
}

// A calf with a foot welded to it stands on the foot alone.
TEST(Feet, OfWeldedLinksAreThoseThatAreCalledSo) {
  const test::ScratchFolder folder;
  const Imported read = read_urdf(folder.write(
      "r.urdf", "<robot name='r'><link name='trunk'>" + kLinkMass + "</link><link name='calf'>" +
                    kLinkMass + shape("<box size='1 1 1'/>") + "</link><link name='FL_foot'>" +
                    shape("<sphere radius='0.02'/>") +
                    "</link><joint name='j' type='continuous'><parent link='trunk'/>"
                    "<child link='calf'/></joint><joint name='k' type='fixed'>"
                    "<origin xyz='0 0 -0.2'/><parent link='calf'/><child link='FL_foot'/></joint>"
                    "</robot>"));
  expect_points(read.robot, {{0, 0, -0.2}}, 0.02);
}

TEST(Feet, ThatAreMissingAreSaid) {
  const std::string mesh = shape("<mesh filename='foot.stl'/>");
  const Imported read = standing({{{"foot", mesh}}});
  EXPECT_TRUE(read.robot.contacts.empty());
  EXPECT_NE(test::all_of(read.notes).find("no contact points: "), std::string::npos);
  // A robot that stands fixed needs none.
  const test::ScratchFolder folder;
  const Imported fixed =
      read_urdf(folder.write("r.urdf", "<robot name='r'><link name='world'/></robot>"));
  EXPECT_EQ(test::all_of(fixed.notes).find("contact points"), std::string::npos);
}

ImportFileOptions on(const std::vector<NamedFeet>& feet) {
  ImportFileOptions options;
  options.feet = feet;
  return options;
}

// A trunk on a calf; welded to that a sole without a shape, and a foot whose mesh is not there.
Imported named(const std::vector<NamedFeet>& feet) {
  const std::string fixed =
      "<joint name='k' type='fixed'><origin xyz='0.01 0 -0.2' "
      "rpy='0 0 1.5707963267948966'/><parent link='calf'/>"
      "<child link='l_sole'/></joint><joint name='m' type='fixed'>"
      "<parent link='calf'/><child link='l_foot'/></joint>";
  const test::ScratchFolder folder;
  return read_urdf(folder.write("r.urdf", "<robot name='r'><link name='trunk'>" + kLinkMass +
                                              "</link><link name='calf'>" + kLinkMass +
                                              shape("<box size='0.1 0.1 0.2'/>") +
                                              "</link><link name='l_sole'/><link name='l_foot'>" +
                                              shape("<mesh filename='foot.stl'/>") +
                                              "</link><joint name='j' type='continuous'>"
                                              "<parent link='trunk'/><child link='calf'/></joint>" +
                                              fixed + "</robot>"),
                   on(feet));
}

std::string why_not(const std::vector<NamedFeet>& feet) {
  try {
    (void)named(feet);
    return "was read";
  } catch (const io::SpecError& error) {
    return error.what();
  }
}

// Its place, where it has no shape; what it collides with, where it has one; the sole that is
// stated, in the link's own axes, which are turned here by a right angle: x is the calf's y.
TEST(NamedFeet, AreTakenInThePlaceOfThoseThatNamesTell) {
  expect_points(named({{"l_s*"}}).robot, {{0.01, 0, -0.2}}, 0);
  expect_points(
      named({{"calf"}}).robot,
      {{0.05, 0.05, -0.1}, {0.05, -0.05, -0.1}, {-0.05, 0.05, -0.1}, {-0.05, -0.05, -0.1}}, 0);
  const Imported soled = named({{"l_sole", SolePatch{-0.05, 0.12, -0.03, 0.03, -0.01}}});
  ASSERT_EQ(soled.robot.contacts.size(), 4u);
  for (const double x_m : {-0.05, 0.12}) {
    for (const double y_m : {-0.03, 0.03}) {
      const Vector3d corner(0.01 - y_m, x_m, -0.21);
      EXPECT_TRUE(std::any_of(soled.robot.contacts.begin(), soled.robot.contacts.end(),
                              [&](const ContactPoint& contact) {
                                return (contact.point.p_B_m - corner).norm() < 1e-15;
                              }))
          << corner.transpose();
    }
  }
  EXPECT_NE(test::all_of(soled.notes).find("as named by --feet: 4 of l_sole (as stated)"),
            std::string::npos)
      << test::all_of(soled.notes);
  // A line has two ends.
  EXPECT_EQ(named({{"l_sole", SolePatch{-0.05, 0.12, 0, 0, 0}}}).robot.contacts.size(), 2u);
}

TEST(NamedFeet, AreRefusedWhereTheyAreNone) {
  EXPECT_NE(why_not({{"r_sole"}}).find("\"r_sole\" fits no link, geom or site"), std::string::npos);
  EXPECT_NE(
      why_not({{"l_foot"}}).find("is not there) say nothing of where they touch; state the sole"),
      std::string::npos)
      << why_not({{"l_foot"}});
  const test::ScratchFolder folder;
  EXPECT_THROW(
      (void)read_urdf(folder.write("r.urdf", "<robot name='r'><link name='world'/></robot>"),
                      on({{"world"}})),
      io::SpecError);
}

TEST(NamedFeet, OfMjcfAreSitesAndGeomsToo) {
  const test::ScratchFolder folder;
  const std::string file = folder.write(
      "r.xml",
      "<mujoco><worldbody><body name='a'><freejoint/><geom size='1'/><body name='b' pos='0 0 -1'>"
      "<joint/><geom name='bar' type='capsule' size='0.02' fromto='0 0 0 0 0 -0.3'/>"
      "<geom name='tip' size='0.03' pos='0 0 -0.3'/>"
      "<body name='c' pos='0.5 0 0'><site name='touch' pos='0 0.25 0'/></body></body></body>"
      "</worldbody></mujoco>");
  expect_points(read_mjcf(file, on({{"tip"}})).robot, {{0, 0, -0.3}}, 0.03);
  expect_points(read_mjcf(file, on({{"touch"}})).robot, {{0.5, 0.25, 0}}, 0);
}

// A class says it too, as in "<geom class='foot'>".
TEST(Feet, OfMjcfAreCalledSoByTheirClass) {
  const test::ScratchFolder folder;
  const Imported read = read_mjcf(folder.write(
      "r.xml",
      "<mujoco><default><default class='foot'><geom type='box' size='0.1 0.1 0.1'/></default>"
      "</default><worldbody><body name='a'><freejoint/><geom size='1'/><body name='b'><joint/>"
      "<geom class='foot'/><geom size='0.02' pos='0 0 0.3'/></body></body></worldbody></mujoco>"));
  expect_points(read.robot,
                {{0.1, 0.1, -0.1}, {0.1, -0.1, -0.1}, {-0.1, 0.1, -0.1}, {-0.1, -0.1, -0.1}}, 0);
}

// What a user could name is in the note.
TEST(Feet, ThatAreMissingCouldBeNamed) {
  const Imported read = standing({{{"left_foot", shape("<mesh filename='foot.stl'/>")}}});
  EXPECT_NE(test::all_of(read.notes)
                .find("--feet NAME=X0:X1,Y0:Y1,Z states a sole in its axes, in "
                      "m (names: left_foot)"),
            std::string::npos)
      << test::all_of(read.notes);
}

}  // namespace
}  // namespace torquewright::hopper
