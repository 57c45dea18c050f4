// SPDX-License-Identifier: Apache-2.0
// Links that follow a robot's joints (key followers), in both engines. Oracles: MuJoCo on the
// file itself, which closes the loops by its own constraints; momentum, for the ground bears all
// that weighs; a joint that has all the friction of its parallelogram.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "dynamics/position_step.hpp"
#include "hopper/engines/engine.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/robot_centroid.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

const std::string kBar =
    R"(<inertial pos="0.01 0.005 -0.02" mass="0.3" quat="0.8 0 0.6 0" diaginertia="4e-4 5e-4 3e-4"/>)";
const std::string kShank =
    R"(<inertial pos="0.02 0.01 -0.1" mass="1.5" quat="0.6 0.8 0 0" diaginertia="0.02 0.03 0.015"/>)";

/// A trunk on a leg whose knee turns a crank by a rod with a spring; nothing is driven.
std::string leg(const std::string& of_crank) {
  return R"(<mujoco><compiler angle="radian"/><option timestep="1e-4" integrator="RK4"/><worldbody>
  <body name="trunk" pos="0.1 0.2 1"><freejoint/>
  <inertial pos="0.01 0.02 0.03" mass="6" diaginertia="0.08 0.07 0.05"/>
  <body name="crank" pos="0.05 0.01 0.02"><joint name="c" axis="0 -1 0" armature="0.02" damping="0.1")" +
         of_crank + "/>" + kBar +
         R"(<body name="rod" pos="0.06 0 -0.01">
  <joint name="r" axis="0 1 0" stiffness="2" springref="0.2"/>)" +
         kBar + R"(</body></body><body name="shank" pos="0.02 0.03 -0.3">
  <joint name="knee" axis="0 1 0" range="-0.7 0.3" limited="true"/>)" +
         kShank + R"(<body name="foot" pos="0 0 -0.2"><joint name="toe" axis="0 1 0"/>
  <inertial pos="0.03 0 -0.02" mass="0.4" diaginertia="1e-3 1e-3 1e-3"/>
  <geom name="sole" size="0.03" pos="0.03 0 -0.02"/></body></body></body></worldbody>
  <equality><connect body1="shank" body2="rod" anchor="0.08 0 -0.03" solref="2e-4 1"
  solimp="0.9999 0.9999 0.001 0.5 2"/></equality></mujoco>)";
}

/// Knee and crank side by side, as long as one another; the trunk stands.
std::string parallelogram(double crank_Nm, double rod_Nm, double knee_Nm) {
  const auto friction = [](double value_Nm) {
    return "frictionloss=\"" + std::to_string(value_Nm) + "\"";
  };
  return R"(<mujoco><compiler angle="radian"/><worldbody><body name="trunk">
  <inertial pos="0 0 0" mass="6" diaginertia="0.08 0.07 0.05"/>
  <body name="crank" pos="0 0 0.3"><joint name="c" axis="0 1 0" )" +
         friction(crank_Nm) + "/>" + kBar +
         R"(<body name="rod" pos="0.08 0 0"><joint name="r" axis="0 1 0" )" + friction(rod_Nm) +
         "/>" + kBar + R"(</body></body><body name="shank"><joint name="knee" axis="0 1 0" )" +
         friction(knee_Nm) + R"( range="-1.2 1.2" limited="true"/>)" + kShank +
         R"(<body name="foot" pos="0 0 -0.2"><joint name="toe" axis="0 1 0"/>
  <inertial pos="0.03 0 -0.02" mass="0.4" diaginertia="1e-3 1e-3 1e-3"/></body></body></body>
  </worldbody><equality><connect body1="shank" body2="rod" anchor="0.08 0 0"/></equality></mujoco>)";
}

Robot robot_of_text(const std::string& text) {
  const test::ScratchFolder folder;
  return read_mjcf(folder.write("robot.xml", text)).robot;
}

/// Where a robot of these joints begins, its trunk 1 m up, turning.
VectorXd begin(const Robot& robot) {
  VectorXd position = dynamics::zero_position(robot.tree);
  if (robot.tree.base == dynamics::BaseKind::kSpatial) position.head<3>() << 0.1, 0.2, 1.0;
  return position;
}

void run(Engine& engine, const VectorXd& position, const VectorXd& velocity, double step_s,
         double duration_s) {
  engine.start(position, velocity);
  const VectorXd none = VectorXd::Zero(velocity.size());
  for (int i = 0; i < std::lround(duration_s / step_s); ++i) {
    ASSERT_EQ(engine.step(none, step_s), EngineOutcome::kStepped) << engine.name() << i;
  }
}

class FollowedLinks : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto absence = mujoco_absence()) GTEST_SKIP() << *absence;
  }
};

TEST_F(FollowedLinks, FlyAsTheirFileDoesInMujoco) {
  const Robot robot = robot_of_text(leg(""));
  ASSERT_EQ(robot.followers.size(), 1u);
  VectorXd velocity(8);
  velocity << 0.3, -0.2, 1.5, 1.0, -2.0, 0.5, -1.5, 2.0;
  const auto own = own_engine(robot, {.ground_height_m = -10});
  const auto mujoco = mujoco_engine(robot, {.ground_height_m = -10});
  for (Engine* engine : {own.get(), mujoco.get()}) {
    run(*engine, begin(robot), velocity, 5e-4, 0.2);
  }
  VectorXd apart(8);
  dynamics::position_difference(robot.tree, own->position(), mujoco->position(), apart);
  EXPECT_LT(apart.cwiseAbs().maxCoeff(), 1e-6) << apart.transpose();

  // The file's own crank and rod begin as fast as the knee turns them.
  test::MujocoEngine file(leg(""));
  WholeBody body(robot);
  ASSERT_TRUE(body.set(begin(robot), velocity));
  const auto dof = [&](const char* name) {
    return file.model().jnt_dofadr[mj_name2id(&file.model(), mjOBJ_JOINT, name)];
  };
  const auto at = [&](const char* name) {
    return file.data().qpos[file.model().jnt_qposadr[mj_name2id(&file.model(), mjOBJ_JOINT, name)]];
  };
  for (int i = 0; i < 6; ++i) file.data().qvel[i] = velocity[i];
  file.data().qvel[dof("knee")] = velocity[6];
  file.data().qvel[dof("toe")] = velocity[7];
  ASSERT_EQ(body.links().size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    file.data().qvel[dof(body.links()[i].joint.name.c_str())] = body.link_motion(i).dot(velocity);
  }
  for (int i = 0; i < 2000; ++i) mj_step(&file.model(), &file.data());
  // Its loop is held by springs that leave 1e-4 of what opens it.
  constexpr double kSoft = 1e-3;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(own->position()[i], file.data().qpos[i], kSoft) << i;
  EXPECT_NEAR(std::abs(own->position().segment<4>(3).dot(
                  Eigen::Map<const Eigen::Vector4d>(file.data().qpos + 3))),
              1.0, kSoft);
  EXPECT_NEAR(own->position()[7], at("knee"), kSoft);
  EXPECT_NEAR(own->position()[8], at("toe"), kSoft);
  EXPECT_GT(std::abs(own->position()[7]), 0.05);  // it did move
}

// The ground's impulse is what stops the fall of all that weighs, links among it.
TEST_F(FollowedLinks, AreBorneByTheGround) {
  const Robot robot = robot_of_text(leg(""));
  constexpr double kFall_s = 0.3, kStep_s = 5e-4;
  RobotCentroid centroid(robot);
  for (const auto& make : {own_engine, mujoco_engine}) {
    const auto engine = make(robot, {.ground_height_m = 0.35});
    VectorXd velocity = VectorXd::Zero(8);
    const double before_m_s = centroid.at(begin(robot), velocity).velocity_m_s.z();
    engine->start(begin(robot), velocity);
    double upward_N_s = 0;
    for (int i = 0; i < std::lround(kFall_s / kStep_s); ++i) {
      ASSERT_EQ(engine->step(VectorXd::Zero(8), kStep_s), EngineOutcome::kStepped);
      for (Index k = 0; k < engine->impulses_N_s().size() / 3; ++k) {
        upward_N_s += engine->impulses_N_s()[3 * k + 2];
      }
    }
    const dynamics::Centroid after = centroid.at(engine->position(), engine->velocity());
    const double fallen_N_s = after.mass_kg * robot.tree.gravity_m_s2 * kFall_s;
    EXPECT_NEAR(after.mass_kg, 6 + 1.5 + 0.4 + 0.6, 1e-12);
    EXPECT_GT(upward_N_s, 0.3 * fallen_N_s) << engine->name();
    EXPECT_NEAR(after.mass_kg * (after.velocity_m_s.z() - before_m_s), upward_N_s - fallen_N_s,
                2e-3 * fallen_N_s)  // of a step's order
        << engine->name();
  }
}

TEST_F(FollowedLinks, WithDryFrictionAreRefusedByMujocosEngineByName) {
  const Robot robot = robot_of_text(leg(" frictionloss=\"0.3\""));
  try {
    (void)mujoco_engine(robot, {});
    FAIL() << "was made";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(
        std::string(error.what()).find("\"c\", a joint within a loop, has dry friction of 0.3"),
        std::string::npos)
        << error.what();
  }
}

// In a parallelogram crank and rod turn as fast as the knee does, so that their friction is the
// knee's: 0.3 + 0.2 + 0.1 Nm. It swings, and comes to rest off the vertical.
TEST(LinksOfALoop, BrakeByTheirFriction) {
  const Robot shared = robot_of_text(parallelogram(0.3, 0.2, 0.1));
  const Robot alone = robot_of_text(parallelogram(0, 0, 0.6));
  ASSERT_EQ(shared.followers.size(), 1u);
  const auto one = own_engine(shared, {});
  const auto other = own_engine(alone, {});
  VectorXd velocity(2);
  velocity << 6.0, 1.0;
  double turned_rad = 0;
  for (const double until_s : {0.05, 0.2, 1.5}) {
    run(*one, begin(shared), velocity, 1e-3, until_s);
    run(*other, begin(alone), velocity, 1e-3, until_s);
    EXPECT_LT((one->position() - other->position()).cwiseAbs().maxCoeff(), 1e-7) << until_s;
    turned_rad = std::max(turned_rad, std::abs(one->position()[0]));
  }
  EXPECT_GT(turned_rad, 0.2);
}

}  // namespace
}  // namespace torquewright::hopper
