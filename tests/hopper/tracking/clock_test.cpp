// SPDX-License-Identifier: Apache-2.0
// Oracle: arithmetic of times, by hand.
#include <gtest/gtest.h>

#include "dynamics/position_step.hpp"
#include "hopper/tracking/reference_clock.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

class FlipClock : public testing::Test {
 protected:
  ClockReading read(double time_s, bool touches) {
    return clock.read(time_s, TouchingPoints::Constant(4, touches));
  }

  test::PlannedMotion planned{"hopper.json", "hopper_flip.csv"};
  double impact_s = planned.reference->modes()[3].from_s;
  ClockOptions options;
  ReferenceClock clock{*planned.reference, options};
};

TEST_F(FlipClock, IsTheTimeWhereAllGoesAsPlanned) {
  for (const double time_s : {0.0, 0.3, 0.6, 0.9, impact_s - 1e-4}) {
    EXPECT_EQ(read(time_s, time_s < 0.6).time_s, time_s);
  }
  EXPECT_NEAR(read(impact_s, true).time_s, impact_s, 1e-15);
  EXPECT_NEAR(read(5.0, true).time_s, 5.0, 1e-14);
  EXPECT_EQ(read(5.0, true).waited_s, 0.0);
}

TEST_F(FlipClock, JumpsToTheImpactWhenTheFootIsEarly) {
  (void)read(0.9, false);
  EXPECT_NEAR(read(impact_s - 0.02, true).time_s, impact_s, 1e-15);
  EXPECT_NEAR(read(impact_s + 0.01, true).time_s, impact_s + 0.03, 1e-15);
  EXPECT_NEAR(read(impact_s + 0.02, false).time_s, impact_s + 0.04, 1e-15);  // it may bounce
}

TEST_F(FlipClock, WaitsInFrontOfTheImpactWhenTheFootIsLate) {
  const ClockReading waiting = read(impact_s + 0.03, false);
  EXPECT_LT(waiting.time_s, impact_s);
  EXPECT_NEAR(waiting.time_s, impact_s, 1e-12);
  EXPECT_NEAR(waiting.waited_s, 0.03, 1e-15);
  EXPECT_NEAR(read(impact_s + 0.04, true).time_s, impact_s, 1e-15);
  EXPECT_NEAR(read(impact_s + 0.05, true).time_s, impact_s + 0.01, 1e-15);
}

TEST_F(FlipClock, WaitsNoLongerThanItMay) {
  EXPECT_GT(read(impact_s + options.longest_wait_s - 1e-6, false).waited_s, 0.0);
  const ClockReading gone_on = read(impact_s + options.longest_wait_s + 1e-6, false);
  EXPECT_EQ(gone_on.waited_s, 0.0);
  EXPECT_NEAR(gone_on.time_s, impact_s, 1e-15);
}

TEST_F(FlipClock, TakesNoStumbleForTheLanding) {
  const double early_s = impact_s - options.earliest_s;
  EXPECT_EQ(read(early_s - 1e-6, true).time_s, early_s - 1e-6);
  EXPECT_NEAR(read(early_s + 1e-6, true).time_s, impact_s, 1e-15);
}

TEST_F(FlipClock, RunsOnWhereItShall) {
  options.resynchronise = false;
  clock = ReferenceClock(*planned.reference, options);
  EXPECT_EQ(read(impact_s - 0.02, true).time_s, impact_s - 0.02);
  EXPECT_EQ(read(impact_s + 0.03, false).time_s, impact_s + 0.03);
}

TEST_F(FlipClock, ForgetsAtTheStart) {
  (void)read(impact_s - 0.02, true);
  clock.start();
  EXPECT_EQ(read(0.9, false).time_s, 0.9);
}

// A fall: z'' = -g while it waits.
TEST_F(FlipClock, MotionGoesOnWhileItWaits) {
  ReferenceInstant before, waiting;
  const double just_before_s = std::nextafter(impact_s, 0.0);
  instant_at(*planned.reference, planned.robot.tree, {just_before_s, 0.0}, before);
  instant_at(*planned.reference, planned.robot.tree, {just_before_s, 0.02}, waiting);
  EXPECT_NEAR(waiting.velocity[2] - before.velocity[2], 0.02 * before.acceleration[2], 1e-14);
  EXPECT_NEAR(waiting.position[2] - before.position[2],
              0.02 * before.velocity[2] + 0.5 * 0.02 * 0.02 * before.acceleration[2], 1e-14);
  EXPECT_EQ(waiting.drive_Nm, before.drive_Nm);
}

}  // namespace
}  // namespace torquewright::hopper
