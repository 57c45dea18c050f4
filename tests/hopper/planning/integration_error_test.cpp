// SPDX-License-Identifier: Apache-2.0
// Oracles: motions that are known. A pendulum on a flat foot, whose torque follows from its angle
// by Lagrange's equation; the same robot on one point, stated by two documents; a leg in flight
// that MuJoCo integrates (integration_error_mujoco_test.cpp).
#include "hopper/planning/programme/integration_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

/// Swings upright on its flat foot, 0.3 rad to either side, within half a second.
class SwingingPendulum {
 public:
  double angle(double t) const { return 0.3 * std::sin(kRate * t) + 0.1; }
  double rate(double t) const { return 0.3 * kRate * std::cos(kRate * t); }
  double second(double t) const { return -0.3 * kRate * kRate * std::sin(kRate * t); }
  /// Lagrange: (K + J) theta'' = m g l sin(theta) - u; the joint turns against the base.
  double torque_Nm(double t) const {
    return is_.mass_kg * plane_.robot.tree.gravity_m_s2 * is_.height_m * std::sin(angle(t)) -
           (is_.base_kg_m2 + is_.rotor_kg_m2) * second(t);
  }
  const SagittalRobot& plane() const { return plane_; }

  PlannedMotion plan(int intervals) const {
    PlannedPhase phase{"flat", {true, true}, {}};
    for (int i = 0; i <= 2 * intervals; ++i) {
      const double t = kLength_s * i / (2.0 * intervals);
      PlannedInstant at;
      at.time_s = t;
      at.position = Eigen::Vector4d(0.0, 0.0, 0.0, -angle(t));
      at.velocity = Eigen::Vector4d(0.0, 0.0, 0.0, -rate(t));
      at.acceleration = Eigen::Vector4d(0.0, 0.0, 0.0, -second(t));
      at.drive_Nm = VectorXd::Constant(1, torque_Nm(t));
      phase.instants.push_back(at);
    }
    return {{phase}};
  }
  PhaseError error(const PlannedMotion& motion, int steps = 16) const {
    return integration_errors(plane_, stances_of(plane_, {"flat"}), motion, steps).front();
  }

 private:
  static constexpr double kRate = 8.0;
  static constexpr double kLength_s = 0.5;
  test::Pendulum is_;
  SagittalRobot plane_ = sagittal(test::pendulum(is_, 0.1, 0.15));
};

TEST(IntegrationError, OfAKnownMotionFallsWithTheFourthPowerOfIntervals) {
  const SwingingPendulum pendulum;
  double last_rad = pendulum.error(pendulum.plan(5)).whole_rad;
  EXPECT_GT(last_rad, 1e-7);  // Torques between instants are the plan's parabolas, not the known.
  for (const int intervals : {10, 20, 40}) {
    const double error_rad = pendulum.error(pendulum.plan(intervals)).whole_rad;
    EXPECT_NEAR(last_rad / error_rad, 16.0, 3.0) << intervals;
    last_rad = error_rad;
  }
}

TEST(IntegrationError, FallsWithTheFourthPowerOfSteps) {
  // One plan; what integrates it converges to what 64 steps an interval say, 1/16 a doubling.
  const SwingingPendulum pendulum;
  const PlannedMotion plan = pendulum.plan(2);
  const double limit_rad = pendulum.error(plan, 64).whole_rad;
  double last_rad = std::abs(pendulum.error(plan, 2).whole_rad - limit_rad);
  for (const int steps : {4, 8}) {
    const double off_rad = std::abs(pendulum.error(plan, steps).whole_rad - limit_rad);
    EXPECT_NEAR(last_rad / off_rad, 16.0, 6.0) << steps;
    last_rad = off_rad;
  }
}

TEST(IntegrationError, FindsWhatIsWrongAndWhere) {
  const SwingingPendulum pendulum;
  const PlannedMotion right = pendulum.plan(40);
  const double none_rad = pendulum.error(right).whole_rad;
  ASSERT_LT(none_rad, 1e-6);
  PlannedMotion moved = right;
  moved.phases[0].instants[20].position[3] += 0.01;  // The begin of interval 10, the end of 9.
  const PhaseError error = pendulum.error(moved);
  ASSERT_EQ(error.interval_rad.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) {
    if (i == 9) {
      EXPECT_NEAR(error.interval_rad[i], 0.01, 1e-6);
    } else if (i == 10) {
      EXPECT_NEAR(error.interval_rad[i], 0.01, 1e-3);  // It falls on a little from there.
    } else {
      EXPECT_LT(error.interval_rad[i], 1e-6) << i;
    }
  }
  EXPECT_NEAR(error.whole_rad, 0.01, 2.0 * none_rad);
}

TEST(IntegrationError, CountsVelocitiesOverAnInterval) {
  const SwingingPendulum pendulum;
  PlannedMotion faster = pendulum.plan(40);
  const double interval_s = 0.5 / 40;
  faster.phases[0].instants.back().velocity[3] += 0.2;
  const PhaseError error = pendulum.error(faster);
  EXPECT_NEAR(error.interval_rad.back(), 0.2 * interval_s, 1e-6);
  EXPECT_LT(error.whole_rad, 1e-6);
}

TEST(IntegrationError, IsInfiniteWhereThereIsNoMotion) {
  const SagittalRobot hopper = test::hopper_with_short_rods();
  PlannedPhase phase{"flight", std::vector<bool>(4, false), {}};
  for (int i = 0; i < 3; ++i) {
    PlannedInstant at;
    at.time_s = 0.01 * i;
    at.position = at.velocity = at.acceleration = VectorXd::Zero(6);
    at.position[3] = 1.0;
    at.position[4] = -1.5;  // Rods of the ankle do not reach it.
    at.drive_Nm = VectorXd::Zero(3);
    phase.instants.push_back(at);
  }
  const PhaseError error = integration_errors(hopper, {{"flight", {}}}, {{phase}}).front();
  EXPECT_EQ(error.whole_rad, std::numeric_limits<double>::infinity());
  EXPECT_EQ(error.interval_rad.front(), std::numeric_limits<double>::infinity());
}

/// On its toe, with rows of its heel: the same error as of a robot that has nothing but that toe,
/// whose rows are the toe's own. Neither motion obeys anything: the errors are large and equal.
TEST(IntegrationError, OnTheToeIsThatOfARobotThatHasOnlyTheToe) {
  const test::Pendulum is;
  const SagittalRobot two = sagittal(test::pendulum(is, 0.1, 0.15));
  const SagittalRobot one = sagittal(test::pendulum(is, -0.15, 0.15));
  ASSERT_EQ(one.sole.size(), 1u);
  oracles::Dice dice(5);
  PlannedPhase of_two{"toe", {false, true}, {}}, of_one{"flat", {true}, {}};
  for (int i = 0; i < 5; ++i) {
    // The toe at rest at the origin.
    TreeMotion toe;
    toe.position =
        Eigen::Vector4d(0.0, 0.0, test::uniform(dice, 0, 0.5), test::uniform(dice, 0, 0.5));
    toe.velocity =
        Eigen::Vector4d(0.0, 0.0, test::uniform(dice, -1, 1), test::uniform(dice, -1, 1));
    toe.acceleration = VectorXd::Zero(4);
    const TreeMotion heel =
        frame_motion(two, PlanFrame::kSole, tree_motion(one, PlanFrame::kSole, toe));
    PlannedInstant at;
    at.time_s = 0.02 * i;
    at.drive_Nm = VectorXd::Constant(1, test::uniform(dice, -20, 20));
    at.position = toe.position, at.velocity = toe.velocity, at.acceleration = toe.acceleration;
    of_one.instants.push_back(at);
    at.position = heel.position, at.velocity = heel.velocity, at.acceleration = heel.acceleration;
    of_two.instants.push_back(at);
  }
  const PhaseError theirs = integration_errors(one, {{"flat", {0}}}, {{of_one}}).front();
  const PhaseError ours = integration_errors(two, {{"toe", {1}}}, {{of_two}}).front();
  EXPECT_GT(theirs.whole_rad, 0.01);
  EXPECT_NEAR(ours.whole_rad, theirs.whole_rad, 1e-9);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(ours.interval_rad[i], theirs.interval_rad[i], 1e-9);
  }
}

}  // namespace
}  // namespace torquewright::hopper
