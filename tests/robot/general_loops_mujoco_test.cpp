// SPDX-License-Identifier: Apache-2.0
// Loops of a file that are kept with their own bodies. Oracle: MuJoCo on the same file, its loops
// closed by Newton's method on its own gaps, and all that moves projected by its own constraint
// Jacobian: where the driven joints stand, their ratios, mass matrix and forces.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "io/documents/document.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/whole_body.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/mujoco_loops.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Newton's method leaves 1e-14 m; over levers of centimetres, twice for the inertias.
constexpr double kAsMujoco = 1e-9;
// A rod between balls spins as it likes: ours holds that, MuJoCo's N takes the least speeds. What
// it weighs about its axis, 1e-6 kg m2, is that much of inertias of 1e-2.
constexpr double kOfSpins = 1e-4;
// MuJoCo's N' comes by differences (mujoco_loops.cpp), of the greatest force.
constexpr double kAsDifferences = 1e-7;

Imported imported(const std::string& text, const ImportFileOptions& options = {}) {
  const test::ScratchFolder folder;
  return read_mjcf(folder.write("robot.xml", text), options);
}

std::string why_not(const std::string& text, const ImportFileOptions& options = {}) {
  try {
    (void)imported(text, options);
    return "was read";
  } catch (const io::SpecError& error) {
    return error.what();
  }
}

/// Through its document.
Robot driven(Robot robot) {
  for (Drivetrain& drivetrain : robot.drivetrains) {
    drivetrain.actuator_files.assign(drivetrain.joints.size(),
                                     TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/d110a_ankle.json");
  }
  const std::string text = robot_json(robot).dump();
  return robot_of(io::check_document(nlohmann::json::parse(text), "robot", "robot.json", "")).robot;
}

bool says(const std::vector<std::string>& notes, const std::string& words) {
  return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

const std::string kTrunk = R"(<mujoco><compiler angle="radian"/><worldbody>
  <body name="trunk" pos="0.1 0.2 1"><freejoint/>
  <inertial pos="0.01 0.02 0.03" mass="6" diaginertia="0.08 0.07 0.05"/>)";
const std::string kShank =
    R"(<inertial pos="0.02 0.01 -0.1" mass="1.5" quat="0.6 0.8 0 0" diaginertia="0.02 0.03 0.015"/>)";
const std::string kRod =
    R"(<inertial pos="0.01 0.005 -0.02" mass="0.3" quat="0.8 0 0.6 0" diaginertia="4e-4 5e-4 3e-4"/>)";

std::string drive(const std::string& joint) {
  return R"(<motor name="drive_)" + joint + R"(" joint=")" + joint + R"("/>)";
}

std::string whole(const std::string& bodies, const std::string& connects,
                  const std::string& motors) {
  return kTrunk + bodies + "</body></worldbody><equality>" + connects + "</equality><actuator>" +
         motors + "</actuator></mujoco>";
}

struct LoopCase {
  const char* name;
  std::string text;
  std::vector<std::string> turned;  ///< In the order of the drives.
  double spins = 0;                 ///< What spins of rods leave open, of the mass matrix.
};

std::ostream& operator<<(std::ostream& out, const LoopCase& one) { return out << one.name; }

const std::string kKneeHinge =
    R"(<joint name="knee" axis="0 1 0" range="-0.7 0.3" limited="true" armature="0.01"/>)";

/// A knee that a slide between thigh and shank bends, as a linear actuator does; its cylinder hangs
/// on a hinge, its piston carries the pin.
std::string pushed_knee() {
  return whole(
      R"(<body name="cylinder" pos="0.06 0 -0.05" euler="0 3.3 0"><joint name="pivot" axis="0 1 0" damping="0.2"/>)" +
          kRod +
          R"(<body name="piston" pos="0 0 0.1"><joint name="push" type="slide" axis="0 0 1" armature="3" limited="true" range="-0.1 0.1"/>)" +
          kRod + R"(</body></body><body name="shank" pos="0 0 -0.35">)" + kKneeHinge + kShank +
          "</body>",
      R"(<connect body1="shank" body2="piston" anchor="0.07 0 0.03"/>)", drive("push"));
}

std::string crank_of_ankle(const std::string& n, const std::string& y, const std::string& rod) {
  return R"(<body name="crank_)" + n + R"(" pos="0.01 )" + y + R"( -0.1" quat="0.96 0.28 0 0">
    <joint name="c)" +
         n + R"(" axis="0 0.8 -0.6" armature="0.03"/>)" + kRod + R"(<body name="rod_)" + n +
         R"(" pos="-0.06 0.005 0">)" + rod + "</body></body>";
}

const std::string kBallRod = R"(<inertial pos="0 0 0" mass="0.3" diaginertia="1e-6 1e-6 1e-6"/>)";

/// Two heavy rods to a universal joint, by balls or by two hinges.
std::string heavy_ankle(bool has_balls) {
  const auto rod = [&](const std::string& n) {
    return has_balls ? R"(<joint name="r)" + n + R"(" type="ball"/>)" + kBallRod
                     : R"(<joint name="r)" + n + R"(" axis="0 1 0"/><joint name="s)" + n +
                           R"(" axis="1 0 0"/>)" + kRod;
  };
  const std::string foot =
      R"(<body name="foot" pos="0 0 -0.4" quat="0.995 0 0.0998749217771909 0">
    <joint name="pitch" axis="0 1 0" limited="true" range="-0.4 0.3"/><joint name="roll" axis="1 0 0" limited="true" range="-0.3 0.35" pos="0 0 -0.01"/>)" +
      kShank + "</body>";
  const auto tied = [](const std::string& n, const std::string& y) {
    return R"(<connect body1="foot" body2="rod_)" + n + R"(" anchor="-0.05 )" + y + R"( 0.01"/>)";
  };
  return whole(
      crank_of_ankle("1", "0.05", rod("1")) + crank_of_ankle("2", "-0.04", rod("2")) + foot,
      tied("1", "0.05") + tied("2", "-0.04"), drive("c1") + drive("c2"));
}

/// A crank and a rod in the plane, the rod with a spring; `turned`: which joint has the drive.
std::string heavy_bar(const std::string& turned) {
  return whole(
      R"(<body name="crank" pos="0.05 0.01 0.02"><joint name="c" axis="0 -1 0" armature="0.02" damping="0.1"/>)" +
          kRod +
          R"(<body name="rod" pos="0.06 0 -0.01"><joint name="r" axis="0 1 0" stiffness="2" springref="0.2"/>)" +
          kRod + R"(</body></body><body name="shank" pos="0.02 0.03 -0.3">)" + kKneeHinge + kShank +
          "</body>",
      R"(<connect body1="shank" body2="rod" anchor="0.08 0 -0.03"/>)", drive(turned));
}

/// A crank whose axis is across the knee's: no four-bar, but a universal joint at the rod's end
/// lets it close.
std::string crossed_crank() {
  return whole(
      R"(<body name="crank" pos="0.08 0.1 0.02"><joint name="c" axis="1 0 0.2" armature="0.02"/>)" +
          kRod +
          R"(<body name="rod" pos="0 -0.07 0"><joint name="r" axis="0 1 0"/><joint name="s" axis="1 0 0"/>)" +
          kRod + R"(</body></body><body name="shank" pos="0.02 0.03 -0.3">)" + kKneeHinge + kShank +
          "</body>",
      R"(<connect body1="shank" body2="rod" anchor="0.08 0 0.02"/>)", drive("c"));
}

class GeneralLoops : public testing::TestWithParam<LoopCase> {};

TEST_P(GeneralLoops, MoveAsMujocoMovesThem) {
  const Imported read = imported(GetParam().text);
  EXPECT_TRUE(says(read.notes, "is kept as a loop of its own bodies"));
  const Robot robot = driven(read.robot);
  ASSERT_EQ(robot.drivetrains.size(), 1u);
  ASSERT_EQ(robot.drivetrains.front().mechanism->type(), "loop");
  oracles::Dice dice(71);
  WholeBody body(robot);
  const Index size = robot.tree.velocity_size();
  const auto joints = static_cast<Index>(robot.tree.bodies.size()) - 1;
  double place = 0, ratio = 0, mass = 0, force = 0;
  for (int sample = 0; sample < 20; ++sample) {
    VectorXd q = dynamics::zero_position(robot.tree), v(size), a(size);
    for (Index i = 0; i < joints; ++i) {
      const auto& limits = robot.tree.bodies[static_cast<std::size_t>(i) + 1].joint.limits;
      q[q.size() - joints + i] = test::uniform(dice, limits.position_min, limits.position_max);
    }
    for (Index i = 0; i < size; ++i) {
      v[i] = test::uniform(dice, -2, 2);
      a[i] = test::uniform(dice, -20, 20);
    }
    test::MujocoLoops mujoco(GetParam().text, robot);
    ASSERT_LE(mujoco.close(q.tail(joints)), 1e-12);
    q.head<3>() = Eigen::Vector3d(0.1, 0.2, 1);
    ASSERT_TRUE(body.set(q, v));
    VectorXd drives(static_cast<Index>(body.drive_count()));
    body.drive_positions(drives);
    for (std::size_t i = 0; i < GetParam().turned.size(); ++i) {
      place = std::max(
          place, std::abs(drives[static_cast<Index>(i)] - mujoco.position(GetParam().turned[i])));
      VectorXd one = VectorXd::Zero(drives.size()), at_joints = VectorXd::Zero(size);
      one[static_cast<Index>(i)] = 1;
      body.add_drive_torques(one, at_joints);
      const Eigen::RowVectorXd theirs = mujoco.ratios(GetParam().turned[i]);
      ratio = std::max(ratio, (at_joints.tail(joints).transpose() - theirs).cwiseAbs().maxCoeff());
    }
    MatrixXd ours(size, size);
    body.mass_matrix(ours);
    mass = std::max(mass, test::difference(ours, mujoco.mass_matrix()));
    VectorXd forces(size);
    body.inverse_dynamics(a, forces);
    const VectorXd theirs = mujoco.inverse_dynamics(v, a);
    force = std::max(force, (forces - theirs).cwiseAbs().maxCoeff() / theirs.cwiseAbs().maxCoeff());
  }
  std::printf("places %.2g, ratios %.2g, mass matrix %.2g, forces %.2g of the greatest\n", place,
              ratio, mass, force);
  EXPECT_LE(place, kAsMujoco);
  EXPECT_LE(ratio, kAsMujoco);
  EXPECT_LE(mass, kAsMujoco + GetParam().spins);
  EXPECT_LE(force, kAsDifferences + GetParam().spins);
}

// Oracle: the robot that was written. MuJoCo holds the exported loops as it holds the file's.
TEST_P(GeneralLoops, GoOutAsTheyCameIn) {
  const Robot robot = driven(imported(GetParam().text).robot);
  EXPECT_EQ(robot_json(robot)["mechanisms"], robot_json(driven(robot))["mechanisms"]);
  const Exported exported = mjcf_of(robot, {.closed_loops = true});
  EXPECT_FALSE(says(exported.notes, "links of loops"));
  EXPECT_TRUE(says(mjcf_of(robot).notes, "links of loops"));
  test::MujocoLoops out(exported.text, robot);
  EXPECT_NEAR(out.total_mass_kg(), test::MujocoLoops(GetParam().text, robot).total_mass_kg(),
              1e-12);
  WholeBody body(robot);
  const auto joints = static_cast<Index>(robot.tree.bodies.size()) - 1;
  const VectorXd at = VectorXd::Constant(joints, -0.15);
  ASSERT_LE(out.close(at), 1e-12);
  VectorXd q = dynamics::zero_position(robot.tree);
  q.tail(joints) = at;
  const Index size = robot.tree.velocity_size();
  ASSERT_TRUE(body.set(q, VectorXd::Zero(size)));
  MatrixXd ours(size, size);
  body.mass_matrix(ours);
  EXPECT_LE(test::difference(ours, out.mass_matrix()), kAsMujoco + GetParam().spins);
}

INSTANTIATE_TEST_SUITE_P(
    Looped, GeneralLoops,
    testing::Values(LoopCase{"PushedKnee", pushed_knee(), {"push"}},
                    LoopCase{"HeavyAnkleBalls", heavy_ankle(true), {"c1", "c2"}, kOfSpins},
                    LoopCase{"HeavyAnkleHinges", heavy_ankle(false), {"c1", "c2"}},
                    LoopCase{"HeavyBar", heavy_bar("c"), {"c"}},
                    LoopCase{"BarThatOnlyFollows", heavy_bar("knee"), {"knee"}},
                    LoopCase{"CrossedCrank", crossed_crank(), {"c"}}),
    [](const auto& one) { return std::string(one.param.name); });

std::string rubbing_bar() {
  std::string text = heavy_bar("c");
  const std::string of_crank = "damping=\"0.1\"", of_rod = "springref=\"0.2\"";
  text.replace(text.find(of_crank), of_crank.size(), "frictionloss=\"0.3\"");
  return text.replace(text.find(of_rod), of_rod.size(), of_rod + " frictionloss=\"0.2\"");
}

// What friction takes at the joint is its power over the joint's speed: by MuJoCo's own ratios.
// At rest as much is held, of a need that is less all of it.
TEST(GeneralLoop, RubsAtItsLinks) {
  const Robot robot = driven(imported(rubbing_bar()).robot);
  test::MujocoLoops mujoco(rubbing_bar(), robot);
  WholeBody body(robot);
  const Index size = robot.tree.velocity_size();
  VectorXd q = dynamics::zero_position(robot.tree), v = VectorXd::Zero(size);
  q.tail(1).setConstant(-0.4);
  ASSERT_LE(mujoco.close(q.tail(1)), 1e-12);
  const double limit_Nm =
      0.3 * std::abs(mujoco.ratios("c")[0]) + 0.2 * std::abs(mujoco.ratios("r")[0]);
  ASSERT_GT(std::abs(std::abs(mujoco.ratios("c")[0]) - 1), 0.05);  // no parallelogram
  for (const double speed_rad_s : {-1.5, 2.0}) {
    v[size - 1] = speed_rad_s;
    ASSERT_TRUE(body.set(q, v));
    VectorXd force = VectorXd::Zero(size);
    body.add_dry_friction(VectorXd::Zero(size), force);
    EXPECT_NEAR(force[size - 1], std::copysign(limit_Nm, speed_rad_s), kAsMujoco);
    EXPECT_EQ(force.head(size - 1).norm(), 0);
  }
  v.setZero();
  ASSERT_TRUE(body.set(q, v));
  for (const double needed_Nm : {-3.0, -0.9, 0.05, 0.9, 3.0}) {
    VectorXd needed = VectorXd::Constant(size, 7.0), held(size);
    needed[size - 1] = needed_Nm * limit_Nm;
    body.held_by_friction(v, needed, held);
    EXPECT_NEAR(held[size - 1], std::clamp(needed_Nm, -1.0, 1.0) * limit_Nm, kAsMujoco);
    EXPECT_EQ(held.head(size - 1).norm(), 0);
  }
}

TEST(GeneralLoop, IsOpenedWhereItIsAskedFor) {
  ImportFileOptions options;
  options.opened_loops = {"rod"};
  const Imported read = imported(heavy_bar("c"), options);
  EXPECT_TRUE(says(read.notes, "the loop between \"shank\" and \"rod\" is opened"));
  EXPECT_TRUE(read.robot.drivetrains.empty());
  EXPECT_EQ(read.robot.tree.bodies.size(), 4u);
  options.opened_loops = {"rods"};
  EXPECT_NE(why_not(heavy_bar("c"), options).find("--open-loop"), std::string::npos);
}

TEST(GeneralLoop, IsRefusedWhereItDoesNotCloseOverItsRange) {
  std::string text = heavy_bar("c");
  const std::string range = "range=\"-0.7 0.3\"";
  text.replace(text.find(range), range.size(), "range=\"-2.9 2.9\"");
  const std::string said = why_not(text);
  EXPECT_NE(said.find("within the joint's range of -2.9 to 2.9"), std::string::npos) << said;
}

// Oracle: pivots 1 m apart, a pin 0.1 m from the one, crank and rod that reach 0.1 + 0.2 m from the
// other: all in line they leave 0.6 m.
TEST(GeneralLoop, IsRefusedWithTheGapThatNoPostureCloses) {
  const std::string said = why_not(whole(
      R"(<body name="crank" pos="0 0 0.5"><joint name="c" axis="0 1 0"/>)" + kRod +
          R"(<body name="rod" pos="0 0 -0.1"><joint name="r" axis="0 1 0"/><site name="tip" pos="0 0 -0.2"/>)" +
          kRod +
          R"(</body></body><body name="shank" pos="0 0 -0.5"><joint name="knee" axis="0 1 0"/><site name="pin" pos="0.1 0 0"/>)" +
          kShank + "</body>",
      R"(<connect site1="tip" site2="pin"/>)", drive("c")));
  EXPECT_NE(said.find("does not close from the file's posture, nor from 39 others"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("its points stay 0.6 m apart"), std::string::npos) << said;
  EXPECT_NE(said.find("closes a loop between \"tip\" and \"pin\""), std::string::npos) << said;
}

// Oracle: where MuJoCo's own crank stands at the end.
TEST(GeneralLoop, IsNoShorterThanItsCrankLetsIt) {
  std::string text = heavy_bar("c");
  const std::string range = "range=\"-0.7 0.3\"", crank = "damping=\"0.1\"";
  text.replace(text.find(range), range.size(), "range=\"-0.7 2.9\"");
  text.replace(text.find(crank), crank.size(), "limited=\"true\" range=\"-0.7 0.5\"");
  const Imported read = imported(text);
  EXPECT_TRUE(says(read.notes, "\"knee\" is narrowed from -0.7 .. 2.9"));
  const dynamics::JointLimits& limits = read.robot.tree.bodies[1].joint.limits;
  EXPECT_EQ(limits.position_min, -0.7);
  test::MujocoLoops mujoco(text, read.robot);
  ASSERT_LE(mujoco.close(VectorXd::Constant(1, limits.position_max)), 1e-12);
  const double at_rad = mujoco.position("c");
  EXPECT_LE(std::min(std::abs(at_rad - 0.5), std::abs(at_rad + 0.7)), 1e-9) << at_rad;
}

}  // namespace
}  // namespace torquewright::hopper
