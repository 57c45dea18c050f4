// SPDX-License-Identifier: Apache-2.0
// What an imported robot stands on. Oracles: corners and ends of shapes by hand, names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace torquewright::hopper
