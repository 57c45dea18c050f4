// SPDX-License-Identifier: Apache-2.0
// Oracles: the motion's own rows; a cubic, which Hermite's polynomial repeats; areas under lines.
#include "hopper/tracking/reference.hpp"

#include <gtest/gtest.h>

#include "dynamics/position_step.hpp"
#include "hopper/tracking/reference_clock.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class FlipReference : public testing::Test {
 protected:
  test::PlannedMotion planned{"hopper.json", "hopper_flip.csv"};
  const Reference& reference = *planned.reference;
  ReferenceInstant at;
};

TEST_F(FlipReference, PassesThroughEveryRow) {
  const Motion& motion = planned.motion;
  for (Index row = 0; row + 1 < motion.samples(); ++row) {
    if (motion.time_s(row) == motion.time_s(row + 1)) continue;  // the later one counts
    reference.at(motion.time_s(row), at);
    VectorXd off(9);
    dynamics::position_difference(planned.robot.tree, motion.positions.col(row), at.position, off);
    ASSERT_LT(off.norm(), 1e-12) << row;
    ASSERT_LT((at.velocity - motion.velocities.col(row)).norm(), 1e-12) << row;
    ASSERT_LT((at.acceleration - motion.accelerations.col(row)).norm(), 1e-10) << row;
  }
}

// Positions' slopes are parabolas, velocities straight: h^2/8 of the third derivative apart in the
// middle of rows, h times the change of acceleration over 8; and the file's last digit, over h.
TEST_F(FlipReference, PositionsMoveAtTheirVelocities) {
  constexpr double kMoment_s = 1e-5, kDigit = 1e-9;
  const Motion& motion = planned.motion;
  VectorXd moved(9);
  ReferenceInstant later;
  for (Index row = 0; row + 1 < motion.samples(); ++row) {
    const double h_s = motion.step_s(row);
    if (h_s < 1e-4) continue;
    const double middle_s = motion.time_s(row) + 0.5 * h_s;
    reference.at(middle_s - 0.5 * kMoment_s, at);
    reference.at(middle_s + 0.5 * kMoment_s, later);
    dynamics::position_difference(planned.robot.tree, at.position, later.position, moved);
    const VectorXd off = moved / kMoment_s - 0.5 * (at.velocity + later.velocity);
    const VectorXd change = motion.accelerations.col(row + 1) - motion.accelerations.col(row);
    // Twice: the base's axes turn.
    ASSERT_LT(off.norm(), 2.0 * h_s * change.norm() / 8.0 + 10.0 * kDigit / h_s) << row;
  }
}

TEST_F(FlipReference, JumpsAtTheImpactAndNowhereElse) {
  const auto& modes = reference.modes();
  ASSERT_EQ(modes.size(), 4u);  // whole foot, heel, flight, whole foot
  EXPECT_TRUE(modes[0].touches.all());
  EXPECT_EQ(modes[1].touches.count(), 2);
  EXPECT_FALSE(modes[2].touches.any());
  EXPECT_TRUE(modes[3].touches.all());
  for (std::size_t mode = 0; mode < modes.size(); ++mode) {
    EXPECT_EQ(modes[mode].begins_with_impact, mode == 3);
    if (mode > 0) {
      EXPECT_EQ(modes[mode].from_s, modes[mode - 1].until_s);
    }
  }
  const double impact_s = modes[3].from_s;
  ReferenceInstant before;
  reference.at(std::nextafter(impact_s, 0.0), before);
  reference.at(impact_s, at);
  EXPECT_GT((at.velocity - before.velocity).norm(), 1.0);
  VectorXd moved(9);
  dynamics::position_difference(planned.robot.tree, before.position, at.position, moved);
  EXPECT_LT(moved.norm(), 1e-9);
  EXPECT_EQ(reference.mode_at(std::nextafter(impact_s, 0.0)), 2u);
  EXPECT_EQ(reference.mode_at(impact_s), 3u);
  EXPECT_EQ(reference.nearest_impact(0.0), 3u);
}

TEST_F(FlipReference, StandsAfterItsEnd) {
  const Index last = planned.motion.samples() - 1;
  for (const double later_s : {0.0, 1.0, 100.0}) {
    reference.at(reference.ends_s() + later_s, at);
    EXPECT_EQ(at.position, planned.motion.positions.col(last));
    EXPECT_EQ(at.velocity, VectorXd::Zero(9));
    EXPECT_EQ(at.acceleration, VectorXd::Zero(9));
  }
}

TEST(Reference, RepeatsACubic) {
  const Robot robot = test::robot_of("rabbit.json");
  const Index n = robot.tree.velocity_size();
  const auto place = [&](double t) -> VectorXd {
    return VectorXd::LinSpaced(n, -1.0, 1.0) * (1.0 - t + 2.0 * t * t - 3.0 * t * t * t);
  };
  const auto speed = [&](double t) -> VectorXd {
    return VectorXd::LinSpaced(n, -1.0, 1.0) * (-1.0 + 4.0 * t - 9.0 * t * t);
  };
  Motion motion;
  motion.times_s = {0.0, 0.5};
  motion.positions.resize(n, 2);
  motion.velocities.resize(n, 2);
  for (Index i = 0; i < 2; ++i) {
    motion.positions.col(i) = place(motion.time_s(i));
    motion.velocities.col(i) = speed(motion.time_s(i));
  }
  motion.accelerations = Eigen::MatrixXd::Zero(n, 2);
  ContactSchedule contacts;
  contacts.touches = Touching::Constant(static_cast<Index>(robot.contacts.size()), 2, false);
  const Reference reference(robot, motion, contacts, Eigen::MatrixXd(0, 2));
  ReferenceInstant at;
  for (const double t : {0.0, 0.1, 0.37, 0.49}) {
    reference.at(t, at);
    EXPECT_LT((at.position - place(t)).norm(), 1e-14) << t;
  }
}

// Torques of one drive: 0 to 10 Nm over 0.1 s, held over 0.1 s, then at once -20 Nm by an impact,
// held over 0.1 s.
class DriveTorques : public testing::Test {
 protected:
  Reference reference() const {
    Motion motion;
    motion.times_s = {0.0, 0.1, 0.2, 0.2, 0.3};
    const Index n = robot.tree.velocity_size();
    motion.positions = motion.velocities = motion.accelerations = Eigen::MatrixXd::Zero(n, 5);
    motion.breaks = {3};
    ContactSchedule contacts;
    contacts.touches = Touching::Constant(static_cast<Index>(robot.contacts.size()), 5, false);
    Eigen::MatrixXd drive_Nm(1, 5);
    drive_Nm << 0.0, 10.0, 10.0, -20.0, -20.0;
    return {robot, motion, contacts, drive_Nm};
  }
  Robot robot = test::robot_of("rabbit.json");
};

TEST_F(DriveTorques, MeansAreAreasUnderLines) {
  const Reference of = reference();
  const auto mean_Nm = [&](double from_s, double until_s) {
    return of.mean_drive_Nm(from_s, until_s)[0];
  };
  EXPECT_NEAR(mean_Nm(0.04, 0.04), 4.0, 1e-12);
  EXPECT_NEAR(mean_Nm(0.02, 0.06), 4.0, 1e-12);
  EXPECT_NEAR(mean_Nm(0.08, 0.14), (0.02 * 9.0 + 0.04 * 10.0) / 0.06, 1e-12);
  EXPECT_NEAR(mean_Nm(0.19, 0.22), (0.01 * 10.0 - 0.02 * 20.0) / 0.03, 1e-12);
  EXPECT_NEAR(mean_Nm(0.0, 0.4), (0.5 + 1.0 - 2.0 - 2.0) / 0.4, 1e-12);  // on after its end
  EXPECT_NEAR(mean_Nm(1.0, 2.0), -20.0, 1e-12);
}

TEST_F(DriveTorques, AreFedForwardForWhenTheyActButNotFromBeyondAnImpact) {
  const Reference of = reference();
  EXPECT_NEAR(fed_forward_Nm(of, {0.02, 0.0}, 0.01, 0.02)[0], 4.0, 1e-12);
  // Held across the impact: only what comes before it counts, the ramp's end and 0.1 s of 10 Nm.
  EXPECT_NEAR(fed_forward_Nm(of, {0.09, 0.0}, 0.0, 0.2)[0], (0.01 * 9.5 + 0.1 * 10.0) / 0.11, 1e-9);
  EXPECT_NEAR(fed_forward_Nm(of, {0.19, 0.0}, 0.05, 0.01)[0], 10.0, 1e-9);
  EXPECT_NEAR(fed_forward_Nm(of, {0.2, 0.0}, 0.0, 0.05)[0], -20.0, 1e-12);
}

}  // namespace
}  // namespace torquewright::hopper
