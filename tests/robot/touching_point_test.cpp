// SPDX-License-Identifier: Apache-2.0
// Oracle: a ball that rolls, in closed form: at the ground its velocity is zero and its
// acceleration w^2 r towards the centre.
#include "robot/model/touching_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

constexpr double kRadius_m = 0.03;

/// One body whose ball sits away from its origin.
Robot ball() {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kSpatial;
  robot.tree.bodies.resize(1);
  robot.contacts.push_back({"ball", {0, {0.05, -0.02, -0.1}}, 0.8, 0.0, kRadius_m});
  return robot;
}

TEST(TouchingPoint, OfARollingBallStandsAndIsDrawnToTheCentre) {
  const Robot robot = ball();
  dynamics::TreeState state(robot.tree);
  const Eigen::Quaterniond R(Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()));
  const Vector3d turn_rad_s(3.0, -7.0, 0.0);  // level: in the world's axes
  const Vector3d up_m(0, 0, kRadius_m);
  const Vector3d to_center_m = R * robot.contacts[0].point.p_B_m;
  Eigen::VectorXd q(7), v(6);
  q << 0.3, 0.1, 0.5, R.w(), R.x(), R.y(), R.z();
  // The centre moves at w x r n; the base's origin by w x its arm less.
  v << turn_rad_s.cross(up_m) - turn_rad_s.cross(to_center_m), R.conjugate() * turn_rad_s;
  state.set(q, v);
  const dynamics::BodyPoint point = touching_point(robot.contacts[0], state);
  const Vector3d center_m = dynamics::point_position_m(state, robot.contacts[0].point);
  constexpr double kRounding = 1e-14;
  EXPECT_LT((dynamics::point_position_m(state, point) - (center_m - up_m)).norm(), kRounding);
  EXPECT_LT(dynamics::point_velocity_m_s(state, point).norm(), kRounding);
  // At constant w and speed of the centre: the origin's acceleration makes up for its arm.
  const Vector3d of_origin_m_s2 = -turn_rad_s.cross(turn_rad_s.cross(to_center_m));
  const Vector3d found_m_s2 = of_origin_m_s2 + dynamics::point_bias_acceleration_m_s2(state, point);
  const Vector3d inward_m_s2(0, 0, turn_rad_s.squaredNorm() * kRadius_m);
  EXPECT_LT((found_m_s2 - inward_m_s2).norm(), 100 * kRounding);
}

TEST(TouchingPoint, WithoutARadiusIsThePointItself) {
  Robot robot = ball();
  robot.contacts[0].radius_m = 0.0;
  dynamics::TreeState state(robot.tree);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(7);
  q[3] = 0.6;
  q[4] = 0.8;
  state.set(q, Eigen::VectorXd::Zero(6));
  EXPECT_EQ(touching_point(robot.contacts[0], state).p_B_m, robot.contacts[0].point.p_B_m);
}

constexpr const char* kMjcf = R"(<mujoco model="leg">
  <default><default class="foot"><geom type="sphere" size="0.02" friction="0.7"/></default></default>
  <worldbody>
    <body name="trunk" pos="0 0 1"><freejoint/>
      <inertial pos="0 0 0" mass="2" diaginertia="0.1 0.1 0.1"/>
      <geom type="sphere" size="0.1" mass="0"/>
      <body name="shank" pos="0 0 -0.2"><joint name="knee" axis="0 1 0"/>
        <inertial pos="0 0 -0.1" mass="0.5" diaginertia="0.01 0.01 0.01"/>
        <geom type="sphere" size="0.05" contype="0" conaffinity="0" mass="0"/>
        <body name="sole" pos="0 0 -0.25"><geom name="FL" class="foot" pos="0.01 0 0" mass="0"/></body>
      </body>
    </body>
  </worldbody>
</mujoco>)";

constexpr const char* kUrdf = R"(<robot name="leg">
  <link name="trunk"><inertial><mass value="2"/>
    <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="world"/>
  <joint name="free" type="floating"><parent link="world"/><child link="trunk"/></joint>
  <link name="shank"><inertial><mass value="0.5"/>
    <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="knee" type="continuous"><parent link="trunk"/><child link="shank"/>
    <axis xyz="0 1 0"/></joint>
  <link name="foot"><collision><origin xyz="0.01 0 0"/><geometry><sphere radius="0.02"/></geometry>
    </collision></link>
  <joint name="ankle" type="fixed"><parent link="shank"/><child link="foot"/>
    <origin xyz="0 0 -0.25"/></joint>
</robot>)";

void expect_foot(const Robot& robot, const char* name, double friction) {
  ASSERT_EQ(robot.contacts.size(), 1u);
  const ContactPoint& foot = robot.contacts[0];
  EXPECT_EQ(foot.name, name);
  EXPECT_EQ(foot.point.body, 1u);
  EXPECT_EQ(foot.point.p_B_m, Vector3d(0.01, 0, -0.25));
  EXPECT_EQ(foot.radius_m, 0.02);
  EXPECT_EQ(foot.friction_coefficient, friction);
}

TEST(Feet, AreTheBallsOfBodiesThatCarryNoOther) {
  const test::ScratchFolder scratch;
  const Robot mjcf = read_mjcf(scratch.write("leg.xml", kMjcf)).robot;
  expect_foot(mjcf, "FL", 0.7);
  EXPECT_TRUE(mjcf.assumed.empty());
  const Robot urdf = read_urdf(scratch.write("leg.urdf", kUrdf)).robot;
  expect_foot(urdf, "foot", 0.8);
  EXPECT_EQ(urdf.assumed, std::vector<std::string>{"/contacts/0/friction_coefficient"});
}

}  // namespace
}  // namespace torquewright::hopper
