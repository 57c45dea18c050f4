// SPDX-License-Identifier: Apache-2.0
// Rows of a motion that nothing explains. Oracle: the same motion without them, and momentum: what
// moves the robot is no error of a row.
#include "hopper/check/left_out_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hopper/check/hopper_check.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/motion/slopes.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kTwitch_m_s2 = 20.0;  // along the ground: friction gives a third

class Squat : public testing::Test {
 protected:
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  Motion motion = read_motion(
      robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_squat.csv", {}, {}, {}});
  CheckOptions options;

  Squat() {
    derive_rates(robot.tree, motion);
    motion.velocity_origin = motion.acceleration_origin = Origin::kGiven;
    motion.reach = 0;
  }

  HopperReport check() const {
    Motion own = motion;
    return check_motion(robot, own, options);
  }

  void twitch(Index first, Index count) {
    for (Index i = first; i < first + count; ++i) motion.accelerations(0, i) += kTwitch_m_s2;
  }

  std::string refusal() const {
    try {
      check();
    } catch (const io::SpecError& error) {
      return error.what();
    }
    return "";
  }
};

const Finding* left_out(const HopperReport& report) {
  const auto& findings = report.check.findings;
  const auto at = std::find_if(findings.begin(), findings.end(),
                               [](const Finding& one) { return one.rule == "rows-left-out"; });
  return at == findings.end() ? nullptr : &*at;
}

TEST_F(Squat, IsJudgedWithoutAFewRowsThatNothingExplains) {
  const HopperReport clean = check();
  EXPECT_EQ(left_out(clean), nullptr);
  twitch(200, 1);
  twitch(400, 2);
  const HopperReport report = check();
  const Finding* finding = left_out(report);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(report.demand.left_out, (std::vector<Index>{200, 400, 401}));
  EXPECT_EQ(finding->severity, actuator::Severity::kWarning);
  EXPECT_NEAR(*finding->value, 3.0 / static_cast<double>(motion.samples()), 1e-12);
  EXPECT_EQ(report.check.verdict, clean.check.verdict);
  for (std::size_t i = 0; i < clean.check.drives.size(); ++i) {
    // Of a smooth squat what lies between two rows is between their torques, to second order.
    const double peak_Nm = clean.check.drives[i].interpretation.peak_torque_Nm;
    EXPECT_NEAR(report.check.drives[i].interpretation.peak_torque_Nm, peak_Nm, 1e-3 * peak_Nm);
  }
}

TEST_F(Squat, IsRefusedForOneRowWhereNoneMayBeLeftOut) {
  twitch(200, 1);
  options.left_out_share = 0.0;
  EXPECT_NE(refusal().find("a force on the base"), std::string::npos);
}

// Just inside and just outside of the share.
TEST_F(Squat, IsRefusedForMoreRowsThanMayBe) {
  twitch(200, 3);
  const double share = 3.0 / static_cast<double>(motion.samples());
  options.left_out_share = 1.001 * share;
  EXPECT_EQ(refusal(), "");
  options.left_out_share = 0.999 * share;
  EXPECT_NE(refusal().find("a force on the base"), std::string::npos);
}

// No ground where it stands: gravity lacks at every row.
TEST_F(Squat, IsRefusedThroughout) {
  motion.has_touching = true;
  motion.touching.setZero(static_cast<Index>(robot.contacts.size()), motion.samples());
  options.left_out_share = 0.5;
  EXPECT_NE(refusal(), "");
}

// Half a second of the limit, a tenth of the weight, is a push of 0.49 m/s. 250 N for 20 ms are
// less; fifty times that are more, however few the rows.
TEST_F(Squat, IsRefusedForAPush) {
  const Index some = 1 + static_cast<Index>(0.02 / motion.step_s(200));
  options.left_out_share = 0.5;
  twitch(200, some);
  EXPECT_EQ(refusal(), "");
  for (int i = 0; i < 50; ++i) twitch(200, some);
  EXPECT_NE(refusal().find("a force on the base"), std::string::npos);
}

TEST(ReadBetween, IsStraightOverTimeAndLevelAtTheEnds) {
  Motion motion;
  motion.times_s = {0.0, 1.0, 3.0, 4.0, 5.0};
  Eigen::MatrixXd table(1, 5);
  table << 9, 2, 9, 5, 9;
  read_between(motion, {0, 2, 4}, table);
  EXPECT_TRUE(table.isApprox((Eigen::MatrixXd(1, 5) << 2, 2, 4, 5, 5).finished()));
}

}  // namespace
}  // namespace torquewright::hopper
