// SPDX-License-Identifier: Apache-2.0
// Oracles: conservation of momentum and energy, statics, a pendulum in closed form, the order of
// convergence.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "robot/model/robot_spec.hpp"
#include "tests/hopper/engines/hopper_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::EngineState;

constexpr double kGravity_m_s2 = 9.81;
constexpr double kHopper_kg = 12.45;

void run(Engine& engine, const EngineState& from, double step_s, int steps) {
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(engine.step(from.force, step_s), EngineOutcome::kStepped) << i;
  }
}

TEST(OwnEngine, KeepsAngularMomentumInFlight) {
  const Robot robot = test::hopper_robot();
  WholeBody body(robot);
  const EngineState from = test::flying(robot);
  const auto engine = own_engine(robot, {});
  engine->start(from.position, from.velocity);
  const Vector3d before = test::angular_momentum_Nm_s(body, from.position, from.velocity);
  run(*engine, from, 1e-3, 500);
  const Vector3d after = test::angular_momentum_Nm_s(body, engine->position(), engine->velocity());
  constexpr double kDrift_Nm_s = 1e-6;  // the bar
  EXPECT_LT((after - before).norm(), kDrift_Nm_s);
  EXPECT_EQ(engine->impulses_N_s().norm(), 0.0);
  EXPECT_EQ(engine->generalised_impulse().norm(), 0.0);
}

/// Of all contact points, one after the other.
VectorXd contact_places_m(const Robot& robot, const Engine& engine) {
  dynamics::TreeState state(robot.tree);
  state.set(engine.position(), engine.velocity());
  VectorXd places(3 * static_cast<Index>(robot.contacts.size()));
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    places.segment<3>(3 * static_cast<Index>(i)) =
        dynamics::point_position_m(state, robot.contacts[i].point);
  }
  return places;
}

// Springs hold the posture of statics. The sole falls for some steps before the ground holds it, a
// few g dt^2; from then on the ground holds velocities, and nothing sinks or creeps but by the
// tolerance of the contacts' velocities.
TEST(OwnEngine, StandsWithoutSinking) {
  const Robot robot = test::hopper_robot();
  const EngineState from = test::standing(robot, 1.2);
  for (const double step_s : {1e-4, 5e-4}) {
    const auto engine = own_engine(robot, {});
    engine->start(from.position, from.velocity);
    const VectorXd begun = contact_places_m(robot, *engine);
    VectorXd settled;
    const int steps = static_cast<int>(std::lround(1.0 / step_s));
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(engine->step(test::holding_force(*engine, from), step_s), EngineOutcome::kStepped);
      if (i == steps / 10) settled = contact_places_m(robot, *engine);
    }
    const VectorXd ended = contact_places_m(robot, *engine);
    constexpr double kCreep_m = 1e-9;  // ten times the tolerance, in a second
    EXPECT_LT((ended - settled).cwiseAbs().maxCoeff(), kCreep_m);
    EXPECT_LT((ended - begun).cwiseAbs().maxCoeff(), 4.0 * kGravity_m_s2 * step_s * step_s);
    double up_N_s = 0.0;
    for (Index k = 0; k < 4; ++k) up_N_s += engine->impulses_N_s()[3 * k + 2];
    EXPECT_NEAR(up_N_s, kHopper_kg * kGravity_m_s2 * step_s, 1e-6);
    EXPECT_NEAR(engine->generalised_impulse()[2], up_N_s, 1e-12);
  }
}

// A ground elsewhere is the same ground elsewhere.
TEST(OwnEngine, KnowsTheGroundsHeight) {
  const Robot robot = test::hopper_robot();
  EngineState from = test::standing(robot, 1.2);
  const auto engine = own_engine(robot, {.ground_height_m = 0.25});
  from.position[2] += 0.25;
  engine->start(from.position, from.velocity);
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(engine->step(test::holding_force(*engine, from), 5e-4), EngineOutcome::kStepped);
  }
  EXPECT_NEAR(engine->position()[2], from.position[2], 1e-5);
}

/// Falls without torques: work of the ground and of the stops alone changes the energy.
TEST(OwnEngine, ContactAndStopsNeverGiveEnergy) {
  const Robot robot = test::hopper_robot();
  WholeBody body(robot);
  for (const EngineState& from : {test::touching_down(robot), test::landing_on_heel(robot)}) {
    const auto engine = own_engine(robot, {});
    engine->start(from.position, from.velocity);
    double before_J = test::energy_J(body, from.position, from.velocity);
    double worst_gain_J = 0.0;
    constexpr double kStep_s = 1e-4;
    for (int i = 0; i < 5000; ++i) {
      ASSERT_EQ(engine->step(from.force, kStep_s), EngineOutcome::kStepped) << i;
      const double after_J = test::energy_J(body, engine->position(), engine->velocity());
      worst_gain_J = std::max(worst_gain_J, after_J - before_J);
      before_J = after_J;
    }
    // The scheme itself errs by its second order in a step: velocities of up to 10 rad/s on 30 J.
    constexpr double kOfTheScheme_J = 3e-3;
    EXPECT_LT(worst_gain_J, kOfTheScheme_J);
  }
}

TEST(OwnEngine, HoldsJointsWithinTheirRange) {
  const Robot robot = test::hopper_robot();
  constexpr double kStep_s = 2e-4;
  EngineState from = test::touching_down(robot);
  const auto engine = own_engine(robot, {});
  engine->start(from.position, from.velocity);
  bool met_a_stop = false;
  for (int i = 0; i < 5000; ++i) {
    const VectorXd before = engine->velocity();
    ASSERT_EQ(engine->step(from.force, kStep_s), EngineOutcome::kStepped) << i;
    for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
      const dynamics::JointLimits& limits = robot.tree.bodies[body].joint.limits;
      const auto row = static_cast<Index>(body);
      const double q = engine->position()[6 + row], v = std::abs(before[5 + row]);
      const double beyond = std::max(limits.position_min - q, q - limits.position_max);
      met_a_stop = met_a_stop || beyond > -1e-12;
      ASSERT_LT(beyond, 60.0 * kStep_s) << robot.tree.bodies[body].joint.name << v;
    }
  }
  EXPECT_TRUE(met_a_stop);
}

/// One link on a fixed base, g across its axis, with a range.
Robot pendulum(double most_rad) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kFixed;
  robot.tree.bodies.resize(2);
  robot.tree.bodies[1].name = robot.tree.bodies[1].joint.name = "link";
  robot.tree.bodies[1].inertia = {2.0, {0, 0, -0.3}, 0.05 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies[1].joint.limits.position_min = -1.0;
  robot.tree.bodies[1].joint.limits.position_max = most_rad;
  return robot;
}

// It swings up to the stop, which takes what it has, and stays there while a torque presses on: the
// stop carries what the torque has beyond the weight's moment.
TEST(JointStop, CarriesWhatPressesOnIt) {
  constexpr double kMost_rad = 0.4, kStep_s = 1e-4, kTorque_Nm = 9.0;
  const Robot robot = pendulum(kMost_rad);
  const auto engine = own_engine(robot, {});
  const VectorXd force = VectorXd::Constant(1, kTorque_Nm);
  engine->start(VectorXd::Zero(1), VectorXd::Zero(1));
  double fastest_rad_s = 0.0;
  for (int i = 0; i < 10000; ++i) {
    fastest_rad_s = std::max(fastest_rad_s, std::abs(engine->velocity()[0]));
    ASSERT_EQ(engine->step(force, kStep_s), EngineOutcome::kStepped);
  }
  EXPECT_GT(fastest_rad_s, 1.0);
  EXPECT_NEAR(engine->position()[0], kMost_rad, fastest_rad_s * kStep_s);
  EXPECT_NEAR(engine->velocity()[0], 0.0, 1e-15);    // rounding of a torque of 9 Nm, 0.1 ms
  EXPECT_EQ(engine->generalised_impulse()[0], 0.0);  // of contact points alone
  // Let go, it leaves at once: the stop does not pull.
  const double inertia_kg_m2 = 0.05 + 2.0 * 0.3 * 0.3;
  ASSERT_EQ(engine->step(VectorXd::Zero(1), kStep_s), EngineOutcome::kStepped);
  const double back_rad_s2 = -2.0 * kGravity_m_s2 * 0.3 * std::sin(kMost_rad) / inertia_kg_m2;
  EXPECT_NEAR(engine->velocity()[0], back_rad_s2 * kStep_s, 1e-3 * std::abs(back_rad_s2) * kStep_s);
}

// A ball that is thrown along the ground without turning slides until it rolls: with I = 2/5 m r^2
// at 5/7 of its speed.
TEST(RollingBall, KeepsFiveSeventhsOfItsSpeed) {
  constexpr double kRadius_m = 0.1, kMass_kg = 3.0, kSpeed_m_s = 1.4;
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kSpatial;
  robot.tree.bodies.resize(1);
  robot.tree.bodies[0].inertia = {
      kMass_kg, Vector3d::Zero(),
      0.4 * kMass_kg * kRadius_m * kRadius_m * Eigen::Matrix3d::Identity()};
  for (const bool is_sphere : {false, true}) {
    if (is_sphere) {
      robot.contacts.clear();
      robot.spheres.push_back({{0, Vector3d::Zero()}, kRadius_m});
    } else {
      robot.contacts.push_back({"ball", {0, Vector3d::Zero()}, 0.5, 0.0, kRadius_m});
    }
    const auto engine = own_engine(robot, {});
    VectorXd q = dynamics::zero_position(robot.tree), v = VectorXd::Zero(6);
    q[2] = kRadius_m;
    v.head<2>() << 0.6 * kSpeed_m_s, 0.8 * kSpeed_m_s;
    engine->start(q, v);
    const VectorXd nothing = VectorXd::Zero(6);
    for (int i = 0; i < 2000; ++i) {
      ASSERT_EQ(engine->step(nothing, 5e-4), EngineOutcome::kStepped);
    }
    EXPECT_NEAR(engine->velocity().head<2>().norm(), 5.0 / 7.0 * kSpeed_m_s, 1e-3);
    EXPECT_NEAR(engine->position()[2], kRadius_m, 1e-5);
    dynamics::TreeState state(robot.tree);
    state.set(engine->position(), engine->velocity());
    const Vector3d turn_rad_s = state.motion(0).angular_velocity_rad_s;
    const Vector3d below_m(0, 0, -kRadius_m);
    EXPECT_LT((engine->velocity().head<3>() + turn_rad_s.cross(below_m)).norm(), 1e-9);
  }
}

/// A block on a contact point and on a sphere, with a link that a stop holds up.
Robot propped_block() {
  Robot robot;
  robot.name = "block";
  robot.tree.base = dynamics::BaseKind::kPlanar;
  robot.tree.bodies.resize(2);
  robot.tree.bodies[0].name = "block";
  robot.tree.bodies[0].inertia = {4.0, {0, 0, 0.1}, 0.05 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies[1].name = robot.tree.bodies[1].joint.name = "link";
  robot.tree.bodies[1].joint.p_PB_m = {0, 0, 0.3};
  robot.tree.bodies[1].inertia = {1.0, Vector3d::Zero(), 0.01 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies[1].joint.limits.position_min = 0.0;
  robot.tree.bodies[1].joint.limits.position_max = 1.0;
  robot.contacts.push_back({"foot", {0, {-0.2, 0, 0}}, 0.5, 0.0, 0.0});
  robot.spheres.push_back({{0, {0.2, 0, 0.05}}, 0.05});
  return robot;
}

// A torque of the block on the link that presses it against its stop changes nothing for the
// ground: half the weight is the foot's, and neither the sphere's half nor the stop's moment is in
// what the foot's impulses do to the velocities.
TEST(OwnEngine, TellsContactPointsFromSpheresAndStops) {
  constexpr double kStep_s = 5e-4, kWeight_N = 5.0 * kGravity_m_s2;
  const Robot robot = propped_block();
  const auto engine = own_engine(robot, {});
  VectorXd force = VectorXd::Zero(4);
  force[3] = -7.0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(engine->step(force, kStep_s), EngineOutcome::kStepped);
  }
  EXPECT_LT(engine->velocity().norm(), 1e-9);
  ASSERT_EQ(engine->impulses_N_s().size(), 3);
  // It leans by what it sinks in its first steps, over 0.4 m between the points.
  constexpr double kLean_rad = 4.0 * kGravity_m_s2 * kStep_s * kStep_s / 0.4;
  constexpr double kOfLean_N_s = kLean_rad * kWeight_N * kStep_s;
  EXPECT_NEAR(engine->impulses_N_s()[2], 0.5 * kWeight_N * kStep_s, kOfLean_N_s);
  EXPECT_NEAR(engine->generalised_impulse()[1], engine->impulses_N_s()[2], 1e-15);
  EXPECT_NEAR(engine->generalised_impulse()[2], 0.2 * engine->impulses_N_s()[2], kOfLean_N_s);
  EXPECT_EQ(engine->generalised_impulse()[3], 0.0);
}

/// A landing under the joints' springs, for a tenth of a second.
VectorXd landed(const Robot& robot, const EngineState& from, int steps) {
  const auto engine = own_engine(robot, {});
  engine->start(from.position, from.velocity);
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(engine->step(test::holding_force(*engine, from), 0.1 / steps),
              EngineOutcome::kStepped);
  }
  return engine->position();
}

// Of first order where contact acts (docs/derivations/time_stepping.md, "Contact").
TEST(OwnEngine, ConvergesWithTheStep) {
  const Robot robot = test::hopper_robot();
  const EngineState from = test::landing_on_heel(robot);
  const VectorXd exact = landed(robot, from, 32000);
  const double coarse = (landed(robot, from, 100) - exact).norm();
  const double fine = (landed(robot, from, 1600) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine) / std::log2(1600.0 / 100.0), 1.0, 0.1);
}

TEST(OwnEngine, GivesTheSameBytesTwiceAndForgets) {
  const Robot robot = test::hopper_robot();
  const EngineState from = test::landing_on_heel(robot);
  const auto fresh = own_engine(robot, {});
  const auto used = own_engine(robot, {});
  const EngineState other = test::standing(robot, 1.0);
  used->start(other.position, other.velocity);
  run(*used, other, 3e-4, 50);
  for (Engine* engine : {fresh.get(), used.get()}) {
    engine->start(from.position, from.velocity);
    EXPECT_EQ(engine->impulses_N_s().norm(), 0.0);
    EXPECT_EQ(engine->generalised_impulse().norm(), 0.0);
    run(*engine, from, 2e-4, 300);
  }
  EXPECT_EQ(fresh->position(), used->position());
  EXPECT_EQ(fresh->velocity(), used->velocity());
  EXPECT_EQ(fresh->impulses_N_s(), used->impulses_N_s());
}

TEST(OwnEngine, RefusesWrongSizes) {
  const Robot robot = test::hopper_robot();
  const EngineState from = test::flying(robot);
  const auto engine = own_engine(robot, {});
  EXPECT_THROW(engine->start(from.position.head(9), from.velocity), std::invalid_argument);
  EXPECT_THROW(engine->start(from.position, from.velocity.head(8)), std::invalid_argument);
  VectorXd nan = from.velocity;
  nan[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(engine->start(from.position, nan), std::invalid_argument);
  engine->start(from.position, from.velocity);
  EXPECT_THROW(static_cast<void>(engine->step(from.force.head(8), 1e-3)), std::invalid_argument);
}

TEST(OwnEngine, SaysThatItBlewUp) {
  const Robot robot = test::hopper_robot();
  EngineState from = test::flying(robot);
  const auto engine = own_engine(robot, {});
  engine->start(from.position, from.velocity);
  for (const double most : {1e15, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    from.force[0] = most;
    EXPECT_EQ(engine->step(from.force, 1e-3), EngineOutcome::kBlownUp) << most;
  }
  EXPECT_EQ(engine->position(), from.position);
  EXPECT_EQ(engine->velocity(), from.velocity);
}

// Without stops the ankle's rods do not reach every posture.
TEST(OwnEngine, SaysThatAMechanismDoesNotReach) {
  Robot robot = test::hopper_robot();
  for (dynamics::Body& body : robot.tree.bodies) body.joint.limits = {};
  EngineState from = test::flying(robot);
  const auto engine = own_engine(robot, {});
  engine->start(from.position, from.velocity);
  from.force.tail<3>() << 0.0, 0.0, 60.0;
  EngineOutcome outcome = EngineOutcome::kStepped;
  VectorXd before;
  for (int i = 0; i < 5000 && outcome == EngineOutcome::kStepped; ++i) {
    before = engine->position();
    outcome = engine->step(from.force, 1e-3);
  }
  EXPECT_EQ(outcome, EngineOutcome::kUnreached);
  EXPECT_EQ(engine->position(), before);
}

}  // namespace
}  // namespace torquewright::hopper
