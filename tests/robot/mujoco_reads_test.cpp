// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo itself, which reads the file that we write.
#include <gtest/gtest.h>

#include "dynamics/mass_matrix.hpp"
#include "robot/draft/rotors_in_joints.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/tree_mjcf.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/mujoco_twin.hpp"
#include "tests/robot/same_robot.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Worst relative difference of mass matrices over some states.
double mass_difference(const Robot& robot) {
  test::MujocoEngine mujoco(mjcf_of(robot).text);
  const std::vector<Eigen::Index> rows = test::rows_of_mujoco(robot.tree);
  dynamics::TreeState state(robot.tree);
  const Eigen::Index size = robot.tree.velocity_size();
  oracles::Dice dice(12);
  double worst = 0;
  for (int sample = 0; sample < 50; ++sample) {
    const VectorXd q = test::random_position(dice, robot.tree);
    const VectorXd v = VectorXd::Zero(size);
    VectorXd theirs = q;
    const Eigen::Index base = robot.tree.base_velocity_size();
    const Eigen::Index extra = q.size() - size;
    for (Eigen::Index i = base; i < size; ++i) {
      theirs[i + extra] = q[rows[static_cast<std::size_t>(i)] + extra];
    }
    state.set(q, v);
    mujoco.set(theirs, v);
    MatrixXd mass(size, size);
    MatrixXd swapped(size, size);
    dynamics::mass_matrix(state, mass);
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 0; j < size; ++j) {
        swapped(i, j) = mass(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
      }
    }
    worst = std::max(worst, test::difference(swapped, mujoco.mass_matrix()));
  }
  return worst;
}

TEST(ExportedMjcf, HasOurMassMatrixInMujoco) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    oracles::Dice dice(seed);
    const auto base = static_cast<dynamics::BaseKind>(seed % 3);
    EXPECT_LE(mass_difference(test::random_robot(dice, base)), 1e-9) << seed;
  }
  for (const char* name : {"hopper", "rabbit"}) {
    const std::string file = std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/") + name + ".json";
    Robot robot = read_robot(file).robot;
    // What the file holds of rotors behind linkages, which have their own test.
    std::vector<std::string> notes;
    robot.tree = tree_with_rotors(robot, notes);
    robot.drivetrains.clear();
    EXPECT_LE(mass_difference(robot), 1e-9) << name;
  }
}

const char* const kUnit =
    R"(<inertial><mass value="1"/><inertia ixx="1" iyy="2" izz="2"/></inertial>)";

/// A URDF file of one joint.
std::string arm_with(const std::string& limit) {
  return std::string(
             "<robot name='r'><link name='world'/><link name='a'><inertial><mass value='1'/>"
             "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>") +
         "</link><joint name='j' type='revolute'><parent link='world'/><child link='a'/><limit " +
         limit + "/></joint></robot>";
}

// Oracle: MuJoCo's own reading of the same file.
TEST(ImportedUrdf, HasARangeWhereMujocoHasOne) {
  for (const char* limit : {"effort='10' velocity='2'", "lower='0' upper='0' effort='10'",
                            "lower='-1' upper='1' effort='10'", "lower='0' upper='2'"}) {
    const test::ScratchFolder folder;
    const Robot robot = read_urdf(folder.write("arm.urdf", arm_with(limit))).robot;
    ASSERT_EQ(robot.tree.bodies.size(), 2u) << limit;
    test::MujocoEngine mujoco(arm_with(limit));
    EXPECT_EQ(std::isfinite(robot.tree.bodies[1].joint.limits.position_min),
              mujoco.model().jnt_limited[0] != 0)
        << limit;
  }
}

/// Ours beside what MuJoCo makes of what we write.
test::TwinDifference beside_export(const Robot& robot, const char* top) {
  test::MujocoEngine mujoco(mjcf_of(robot).text);
  return test::compare_with_mujoco(robot, mujoco, top);
}

void expect_same(const test::TwinDifference& far) {
  constexpr double kRoundings = 1e-12;
  EXPECT_EQ(far.trouble, "");
  EXPECT_LE(std::max({far.mass, far.place_m, far.inertia, far.matrix, far.bias}), kRoundings);
}

TEST(ExportedMjcf, OfAnArmOnALinkCalledWorldIsReadByMujoco) {
  const test::ScratchFolder folder;
  const std::string arm = std::string("<link name='a'>") + kUnit +
                          "</link><joint name='j' type='continuous'><parent link='world'/>"
                          "<child link='a'/><origin xyz='1 0 0' rpy='1 0 0'/></joint></robot>";
  for (const char* world : {"<link name='world'/>",
                            "<link name='world'><inertial><mass value='2'/>"
                            "<inertia ixx='1' iyy='1' izz='1'/></inertial></link>"}) {
    const auto file = folder.write("arm.urdf", std::string("<robot name='r'>") + world + arm);
    const Robot robot = read_urdf(file).robot;
    const bool has_mass = robot.tree.bodies[0].inertia.mass_kg > 0;
    expect_same(beside_export(robot, has_mass ? "world_" : "a"));
  }
}

TEST(ExportedMjcf, WritesBodiesWithoutMassAsJointsOfTheNext) {
  const test::ScratchFolder folder;
  const auto file = folder.write("r.xml", R"(<mujoco><worldbody><body name="a"><freejoint/>
    <geom size="0.2"/><body name="b" pos="0.3 0 0.1" euler="10 20 30">
      <joint name="j" ref="20" axis="1 0 0" pos="0.1 0 0"/><joint name="k" type="slide" ref="0.1"/>
      <joint name="l" axis="0 0.6 0.8" pos="0 0.2 0" ref="-30"/>
      <geom type="box" size="0.1 0.2 0.3"/></body></body></worldbody></mujoco>)");
  expect_same(beside_export(read_mjcf(file).robot, "a"));
}

struct Running {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  test::MujocoEngine mujoco{
      mjcf_of(robot, {.actuators = true, .ground = true, .collisions = true}).text};

  void take_key(const char* name) {
    const int key = mj_name2id(&mujoco.model(), mjOBJ_KEY, name);
    ASSERT_GE(key, 0) << name;
    mj_resetDataKeyframe(&mujoco.model(), &mujoco.data(), key);
    mj_forward(&mujoco.model(), &mujoco.data());
  }
};

// Oracle: MuJoCo's own sites at the keyframes, and what it says of its contacts.
TEST(ExportedWhole, StandsOnItsGround) {
  Running running;
  const mjModel& model = running.mujoco.model();
  const mjData& data = running.mujoco.data();
  for (const char* key : {"home", "takeoff", "tuck"}) {
    running.take_key(key);
    double lowest_m = 1;
    for (int site = 0; site < model.nsite; ++site) {
      lowest_m = std::min(lowest_m, data.site_xpos[3 * site + 2]);
    }
    EXPECT_NEAR(lowest_m, 0, 1e-15) << key;
  }
  running.take_key("home");
  ASSERT_EQ(data.ncon, 4);
  for (int i = 0; i < data.ncon; ++i) EXPECT_EQ(data.contact[i].friction[0], 0.6);
  // It falls over, undriven, and never through the ground.
  for (int step = 0; step < 1000; ++step) mj_step(&model, &running.mujoco.data());
  for (int site = 0; site < model.nsite; ++site) EXPECT_GE(data.site_xpos[3 * site + 2], -5e-3);
}

// Oracle: the line of the knee's region by hand (docs/simulator_formats.md), the pack's 16/4 x
// 0.015 ohm in series: 20 x 0.32 x 67.2/(0.28 + 0.06) Nm at stall, 10.5 rad/s without load, at most
// 320.
TEST(ExportedWhole, DrivesAsTheRegionsSay) {
  Running running;
  const int knee = mj_name2id(&running.mujoco.model(), mjOBJ_ACTUATOR, "knee");
  const int joint = mj_name2id(&running.mujoco.model(), mjOBJ_JOINT, "knee");
  ASSERT_GE(knee, 0);
  const int row = running.mujoco.model().jnt_dofadr[joint];
  running.take_key("takeoff");
  mjData& data = running.mujoco.data();
  for (const double speed : {-3.0, 0.0, 8.0, 9.0, 10.5}) {
    data.qvel[row] = speed;
    data.ctrl[knee] = 1000;  // more than the bus has
    mj_forward(&running.mujoco.model(), &data);
    const double line_Nm = 20 * 0.32 * 67.2 / 0.34 * (1 - speed / 10.5);
    EXPECT_NEAR(data.qfrc_actuator[row], std::min(line_Nm, 320.0), 1e-3 * 320) << speed;
  }
}

// Oracle: the robot's own transfer at the posture nearest to zero.
TEST(ExportedWhole, PullsCoupledJointsByTheMechanismsRatios) {
  Running running;
  running.take_key("home");
  const mjModel& model = running.mujoco.model();
  mjData& data = running.mujoco.data();
  const int left = mj_name2id(&model, mjOBJ_ACTUATOR, "ankle_left");
  const int pitch = mj_name2id(&model, mjOBJ_JOINT, "ankle_pitch");
  ASSERT_GE(left, 0);
  data.ctrl[left] = 10;
  mj_forward(&model, &data);
  const Drivetrain& ankle = running.robot.drivetrains[1];
  const SmallVector rest = SmallVector::Zero(2);
  const SmallMatrix J = ankle.mechanism->transfer(rest, rest)->jacobian;
  const int row = model.jnt_dofadr[pitch];
  const double force_Nm = data.actuator_force[left];
  EXPECT_GT(force_Nm, 1);
  EXPECT_NEAR(data.qfrc_actuator[row], J(0, 0) * force_Nm, 1e-12 * force_Nm);
  EXPECT_NEAR(data.qfrc_actuator[row + 1], J(0, 1) * force_Nm, 1e-12 * force_Nm);
}

}  // namespace
}  // namespace torquewright::hopper
