// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo beside our own engine, statics, conservation of momentum. The rotors' inertia
// behind mechanisms is ours in both; closed_loops_mujoco_test.cpp holds it against MuJoCo's own.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "dynamics/position_step.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/hopper/engines/hopper_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::EngineState;

class TwoEngines : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto absence = mujoco_absence()) GTEST_SKIP() << *absence;
  }
};

void run_for(Engine& engine, const EngineState& from, double step_s, double duration_s) {
  engine.start(from.position, from.velocity);
  for (int i = 0; i < std::lround(duration_s / step_s); ++i) {
    ASSERT_EQ(engine.step(from.force, step_s), EngineOutcome::kStepped) << engine.name() << i;
  }
}

double most_apart(const Robot& robot, const Engine& one, const Engine& other) {
  VectorXd difference(robot.tree.velocity_size());
  dynamics::position_difference(robot.tree, one.position(), other.position(), difference);
  return difference.cwiseAbs().maxCoeff();
}

constexpr double kApart_rad = 1e-6;  // the bars
constexpr double kMomentum_Nm_s = 1e-6;

TEST_F(TwoEngines, FlyAlike) {
  const Robot robot = test::hopper_robot();
  WholeBody body(robot);
  const EngineState from = test::flying(robot);
  const Vector3d before = test::angular_momentum_Nm_s(body, from.position, from.velocity);
  const auto own = own_engine(robot, {});
  const auto mujoco = mujoco_engine(robot, {});
  for (Engine* engine : {own.get(), mujoco.get()}) {
    run_for(*engine, from, 1e-3, 0.5);
    const Vector3d after =
        test::angular_momentum_Nm_s(body, engine->position(), engine->velocity());
    EXPECT_LT((after - before).norm(), kMomentum_Nm_s) << engine->name();
    EXPECT_EQ(engine->impulses_N_s().norm(), 0.0);
  }
  EXPECT_GT((own->position() - from.position).norm(), 1.0);
  EXPECT_LT(most_apart(robot, *own, *mujoco), kApart_rad);
}

/// Of the sagittal walker: two legs and a planar base.
EngineState walker_in_flight() {
  EngineState from;
  from.position.resize(7);
  from.position << 0.0, 5.0, 0.3, -0.4, 0.5, 0.3, 0.9;
  from.velocity.resize(7);
  from.velocity << 1.0, 1.5, 2.0, -3.0, 4.0, 1.0, -2.0;
  from.force.resize(7);
  from.force << 0.0, 0.0, 0.0, 5.0, -4.0, 2.0, 1.0;
  return from;
}

TEST_F(TwoEngines, FlyAlikeInThePlane) {
  const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/rabbit.json").robot;
  const auto own = own_engine(robot, {});
  const auto mujoco = mujoco_engine(robot, {});
  for (Engine* engine : {own.get(), mujoco.get()}) run_for(*engine, walker_in_flight(), 1e-3, 0.5);
  EXPECT_GT((own->position() - walker_in_flight().position).norm(), 1.0);
  EXPECT_LT(most_apart(robot, *own, *mujoco), kApart_rad);
}

/// Sums over a landing under the joints' springs.
struct Landing {
  Vector3d on_the_ground_N_s = Vector3d::Zero();
  VectorXd generalised = VectorXd::Zero(9);
};

Landing landing(Engine& engine, const EngineState& from) {
  constexpr double kStep_s = 5e-4, kWindow_s = 0.025;
  Landing sums;
  engine.start(from.position, from.velocity);
  for (int i = 0; i < std::lround(kWindow_s / kStep_s); ++i) {
    EXPECT_EQ(engine.step(test::holding_force(engine, from), kStep_s), EngineOutcome::kStepped);
    for (Index k = 0; k < 4; ++k) {
      sums.on_the_ground_N_s += engine.impulses_N_s().segment<3>(3 * k);
    }
    sums.generalised += engine.generalised_impulse();
  }
  return sums;
}

// The bar: within 5 %. Of loads that share one impact the greatest is the measure.
// Dampers and springs in both, dry friction hard here and a constraint there.
TEST_F(TwoEngines, FlyAlikeWithPassiveJoints) {
  Robot robot = test::hopper_robot();
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    robot.tree.bodies[i].joint.passive = {0.2, 0.0, 0.0, 3.0, 0.4};
  }
  const EngineState from = test::flying(robot);
  const auto own = own_engine(robot, {});
  const auto mujoco = mujoco_engine(robot, {});
  for (Engine* engine : {own.get(), mujoco.get()}) run_for(*engine, from, 1e-4, 0.3);
  constexpr double kSecondOrder_rad = 1e-4;  // ours; a hundred times the difference of a frozen one
  EXPECT_LT(most_apart(robot, *own, *mujoco), kSecondOrder_rad);

  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    robot.tree.bodies[i].joint.passive = {0.0, 0.5, 0.0, 0.0, 0.0};
  }
  const auto hard = own_engine(robot, {});
  const auto soft = mujoco_engine(robot, {});
  for (Engine* engine : {hard.get(), soft.get()}) run_for(*engine, from, 1e-4, 0.3);
  EXPECT_LT(most_apart(robot, *hard, *soft), 5e-3);
  EXPECT_GT(most_apart(robot, *hard, *own), 0.1);
}

TEST_F(TwoEngines, TakeTheSameLoadsAtTouchDown) {
  constexpr double kShare = 0.05;
  const Robot robot = test::hopper_robot();
  const auto own = own_engine(robot, {});
  const auto mujoco = mujoco_engine(robot, {});
  for (const EngineState& from : {test::touching_down(robot), test::landing_on_heel(robot)}) {
    const Landing one = landing(*own, from);
    const Landing other = landing(*mujoco, from);
    EXPECT_GT(one.on_the_ground_N_s.z(), 30.0);  // 12.45 kg at 3.5 m/s, most of it stopped
    EXPECT_LT((one.on_the_ground_N_s - other.on_the_ground_N_s).norm(),
              kShare * one.on_the_ground_N_s.norm());
    const Vector3d joints = one.generalised.tail<3>();
    EXPECT_GT(joints.norm(), 1.0);
    EXPECT_LT((joints - other.generalised.tail<3>()).norm(), kShare * joints.norm());
    for (const Landing& sums : {one, other}) {
      EXPECT_LT((sums.generalised.head<3>() - sums.on_the_ground_N_s).norm(), 1e-10);
    }
  }
}

// Soft ground holds the weight where it is as deep as its stiffness asks: 1e-5 m is far less than
// a replay can tell.
TEST_F(TwoEngines, StandAlike) {
  constexpr double kStep_s = 5e-4, kWeight_N = 12.45 * 9.81;
  const Robot robot = test::hopper_robot();
  const EngineState from = test::standing(robot, 1.2);
  for (const auto& engine : {own_engine(robot, {}), mujoco_engine(robot, {})}) {
    engine->start(from.position, from.velocity);
    for (int i = 0; i < 2000; ++i) {
      ASSERT_EQ(engine->step(test::holding_force(*engine, from), kStep_s), EngineOutcome::kStepped);
    }
    EXPECT_LT((engine->position() - from.position).norm(), 1e-5) << engine->name();
    EXPECT_NEAR(engine->generalised_impulse()[2], kWeight_N * kStep_s, 1e-3 * kWeight_N * kStep_s);
  }
}

TEST_F(TwoEngines, MujocoHoldsJointsWithinTheirRange) {
  const Robot robot = test::hopper_robot();
  const auto engine = mujoco_engine(robot, {});
  const EngineState from = test::touching_down(robot);
  engine->start(from.position, from.velocity);
  constexpr double kStep_s = 5e-4;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(engine->step(from.force, kStep_s), EngineOutcome::kStepped);
    for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
      const dynamics::JointLimits& limits = robot.tree.bodies[body].joint.limits;
      const double q = engine->position()[6 + static_cast<Index>(body)];
      const double beyond = std::max(limits.position_min - q, q - limits.position_max);
      ASSERT_LT(beyond, 0.1);  // two time constants at up to 60 rad/s
    }
  }
}

TEST_F(TwoEngines, MujocoGivesTheSameBytesTwiceAndForgets) {
  const Robot robot = test::hopper_robot();
  const EngineState from = test::landing_on_heel(robot);
  const auto fresh = mujoco_engine(robot, {});
  const auto used = mujoco_engine(robot, {});
  run_for(*used, test::standing(robot, 1.0), 3e-4, 0.015);
  for (Engine* engine : {fresh.get(), used.get()}) run_for(*engine, from, 2e-4, 0.05);
  EXPECT_EQ(fresh->position(), used->position());
  EXPECT_EQ(fresh->velocity(), used->velocity());
  EXPECT_EQ(fresh->impulses_N_s(), used->impulses_N_s());
}

TEST_F(TwoEngines, MujocoRefusesWrongSizes) {
  const Robot robot = test::hopper_robot();
  const EngineState from = test::flying(robot);
  const auto engine = mujoco_engine(robot, {});
  EXPECT_THROW(engine->start(from.position.head(9), from.velocity), std::invalid_argument);
  VectorXd nan = from.velocity;
  nan[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(engine->start(from.position, nan), std::invalid_argument);
  engine->start(from.position, from.velocity);
  EXPECT_THROW(static_cast<void>(engine->step(from.force.head(8), 1e-3)), std::invalid_argument);
}

TEST_F(TwoEngines, MujocoSaysThatItBlewUp) {
  const Robot robot = test::hopper_robot();
  EngineState from = test::flying(robot);
  const auto engine = mujoco_engine(robot, {});
  engine->start(from.position, from.velocity);
  from.force[8] = 1e200;
  EXPECT_EQ(engine->step(from.force, 1e-3), EngineOutcome::kBlownUp);
  EXPECT_EQ(engine->position(), from.position);
  EXPECT_EQ(engine->velocity(), from.velocity);
  from.force[8] = 0.0;  // and goes on
  EXPECT_EQ(engine->step(from.force, 1e-3), EngineOutcome::kStepped);
}

TEST_F(TwoEngines, MujocoSaysThatAMechanismDoesNotReach) {
  Robot robot = test::hopper_robot();
  for (dynamics::Body& body : robot.tree.bodies) body.joint.limits = {};
  EngineState from = test::flying(robot);
  from.force.tail<3>() << 0.0, 0.0, 60.0;
  const auto engine = mujoco_engine(robot, {});
  engine->start(from.position, from.velocity);
  EngineOutcome outcome = EngineOutcome::kStepped;
  for (int i = 0; i < 5000 && outcome == EngineOutcome::kStepped; ++i) {
    outcome = engine->step(from.force, 1e-3);
  }
  EXPECT_EQ(outcome, EngineOutcome::kUnreached);
}

// MuJoCo keeps no entry of the mass matrix for joints of which none carries the other.
TEST_F(TwoEngines, MujocoRefusesRotorsBetweenBranches) {
  const Robot hopper = test::hopper_robot();
  Robot walker = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/rabbit.json").robot;
  Drivetrain differential = hopper.drivetrains.back();
  SmallMatrix sum_and_difference(2, 2);
  sum_and_difference << 1.0, 1.0, 1.0, -1.0;
  differential.mechanism = std::make_shared<ConstantJacobian>("differential", sum_and_difference);
  differential.rotors_in_tree = false;
  differential.joints = {1, 3};  // a hip and its knee
  walker.drivetrains = {differential};
  const auto own = own_engine(walker, {});
  const auto mujoco = mujoco_engine(walker, {});
  for (Engine* engine : {own.get(), mujoco.get()}) run_for(*engine, walker_in_flight(), 1e-3, 0.5);
  EXPECT_LT(most_apart(walker, *own, *mujoco), kApart_rad);
  walker.drivetrains[0].joints = {1, 2};  // both hips
  EXPECT_NO_THROW(own_engine(walker, {}));
  EXPECT_THROW(mujoco_engine(walker, {}), std::invalid_argument);
}

TEST_F(TwoEngines, MujocoRefusesRotorsThatSpin) {
  Robot walker = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/rabbit.json").robot;
  walker.tree.bodies[2].joint.rotor_spin_kg_m2 = {0, 0.01, 0};
  EXPECT_THROW(mujoco_engine(walker, {}), std::invalid_argument);
}

// A ball of a sphere and a ball of a contact point meet the same ground.
TEST_F(TwoEngines, RestOnBalls) {
  Robot robot;
  robot.name = "ball";
  robot.tree.base = dynamics::BaseKind::kSpatial;
  robot.tree.bodies.resize(1);
  robot.tree.bodies[0].name = "ball";
  robot.tree.bodies[0].inertia = {3.0, Vector3d::Zero(), 0.01 * Eigen::Matrix3d::Identity()};
  constexpr double kRadius_m = 0.1, kGround_m = -0.3;
  for (const bool is_sphere : {false, true}) {
    robot.contacts.clear();
    robot.spheres.clear();
    if (is_sphere) {
      robot.spheres.push_back({{0, Vector3d::Zero()}, kRadius_m});
    } else {
      robot.contacts.push_back({"ball", {0, Vector3d::Zero()}, 0.5, 0.0, kRadius_m});
    }
    const EngineOptions options{.ground_height_m = kGround_m};
    for (const auto& engine : {own_engine(robot, options), mujoco_engine(robot, options)}) {
      VectorXd q = dynamics::zero_position(robot.tree);
      q[2] = kGround_m + kRadius_m + 0.01;
      engine->start(q, VectorXd::Zero(6));
      for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(engine->step(VectorXd::Zero(6), 5e-4), EngineOutcome::kStepped);
      }
      EXPECT_NEAR(engine->position()[2], kGround_m + kRadius_m, 3e-4) << engine->name();
      EXPECT_EQ(engine->impulses_N_s().size(), is_sphere ? 0 : 3);
    }
  }
}

// Oracle: ground elsewhere is the same ground elsewhere. A landing 0.3 m higher, beyond an edge, is
// that on the plane. MuJoCo's boxes and planes place a contact differently within what it sinks:
// at 2 m/s by 2 m/s x 1 ms / e (docs/derivations/whole_body_check.md, eqs. (26)-(28)).
TEST_F(TwoEngines, LandOnATerraceAsOnThePlane) {
  const Robot robot = test::hopper_robot();
  EngineState low = test::touching_down(robot);
  low.position[2] -= 1e-6;  // else rounding says in which step it is met
  EngineState high = low;
  high.position[0] += 5.0;
  high.position[2] += 0.3 + 0.1;
  const EngineOptions terraces{.ground_height_m = 0.1, .profile = {{1.0, 9.0}, {0.0, 0.3, -0.2}}};
  const auto pairs = {std::pair(own_engine(robot, {}), own_engine(robot, terraces)),
                      std::pair(mujoco_engine(robot, {}), mujoco_engine(robot, terraces))};
  for (const auto& [plane, terrace] : pairs) {
    const double apart_m = plane->name() == "mujoco" ? 2.0 * 1e-3 / std::numbers::e : 1e-7;
    const Landing on_plane = landing(*plane, low), on_terrace = landing(*terrace, high);
    VectorXd back = terrace->position();
    back[0] -= 5.0;
    back[2] -= 0.4;
    EXPECT_LT((back - plane->position()).cwiseAbs().maxCoeff(), apart_m) << plane->name();
    EXPECT_GT(on_plane.on_the_ground_N_s.z(), 10.0);
    EXPECT_NEAR(on_terrace.on_the_ground_N_s.z(), on_plane.on_the_ground_N_s.z(), 0.1);
  }
}

}  // namespace
}  // namespace torquewright::hopper
