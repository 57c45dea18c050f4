// SPDX-License-Identifier: Apache-2.0
// Oracle: the motion of the file itself, sample by sample, and the plan's own words about phases.
#include "hopper/planning/programme/warm_guess.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hopper/motion/motion_reader.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

class WarmGuess : public testing::Test {
 protected:
  Robot robot = test::documented_robot("hopper");
  PlanModel model = plan_model(robot, PlanOptions());
  Motion motion =
      read_motion(robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_flip.csv", {}, {}, {}});

  PlannedMotion guess(const std::vector<std::string>& names) {
    return warm_guess(robot, model, stances_of(model.plane, names), motion, ContactRule(), "flip");
  }
  std::string refusal(const std::vector<std::string>& names) {
    try {
      guess(names);
    } catch (const io::SpecError& error) {
      return error.what();
    }
    return "";
  }
  /// Stances of the file, found by asking for another order.
  const std::vector<std::string> order{"flat", "heel", "flight", "flat"};
};

TEST_F(WarmGuess, IsTheMotion) {
  const PlannedMotion plan = guess(order);
  ASSERT_EQ(plan.phases.size(), order.size());
  Index sample = 0;
  for (std::size_t p = 0; p < plan.phases.size(); ++p) {
    const PlannedPhase& phase = plan.phases[p];
    EXPECT_EQ(phase.stance, order[p]);
    EXPECT_EQ(phase.flies(), order[p] == "flight");
    EXPECT_EQ(phase.begin_s(), p > 0 ? plan.phases[p - 1].end_s() : motion.times_s.front());
    // It begins with the sample that ended the one before, or with the one after an impact.
    if (p > 0 && !motion.is_break(sample)) --sample;
    for (const PlannedInstant& at : phase.instants) {
      ASSERT_LT(sample, motion.samples());
      ASSERT_EQ(at.time_s, motion.time_s(sample));
      const TreeMotion tree =
          tree_motion(model.plane, phase.frame(), {at.position, at.velocity, at.acceleration});
      const auto q = motion.positions.col(sample);
      EXPECT_NEAR(tree.position[0], q[0], 1e-12);
      EXPECT_NEAR(tree.position[1], q[2], 1e-12);
      EXPECT_NEAR(std::sin(0.5 * tree.position[2]), q[5], 1e-9);  // Or its negative, a turn on.
      EXPECT_NEAR(tree.position[3], q[7], 1e-15);
      EXPECT_NEAR(tree.position[4], q[8], 1e-15);
      const auto v = motion.velocities.col(sample);
      EXPECT_NEAR(tree.velocity[0], v[0], 1e-11);
      EXPECT_NEAR(tree.velocity[1], v[2], 1e-11);
      EXPECT_NEAR(tree.velocity[2], v[4], 1e-11);
      EXPECT_NEAR(tree.velocity[3], v[6], 1e-15);
      ++sample;
    }
  }
  EXPECT_EQ(sample, motion.samples());
  // Once round, without a jump.
  const double turned_rad = plan.phases.back().instants.back().position[2] -
                            plan.phases.front().instants.front().position[2];
  EXPECT_NEAR(turned_rad, 2.0 * M_PI, 1e-6);
}

TEST_F(WarmGuess, DoesNotMindTheSignOfQuaternions) {
  const PlannedMotion as_it_is = guess(order);
  motion.positions.rightCols(motion.samples() / 2).middleRows<4>(3) *= -1.0;
  const PlannedMotion turned = guess(order);
  for (std::size_t p = 0; p < order.size(); ++p) {
    for (std::size_t i = 0; i < turned.phases[p].instants.size(); ++i) {
      EXPECT_LT(
          (turned.phases[p].instants[i].position - as_it_is.phases[p].instants[i].position).norm(),
          1e-12);
    }
  }
}

TEST_F(WarmGuess, TouchesAndLoadsTheStancesPoints) {
  const PlannedMotion plan = guess(order);
  EXPECT_EQ(plan.phases[0].touches, (std::vector<bool>{true, true, true, true}));
  EXPECT_EQ(plan.phases[1].touches, (std::vector<bool>{true, true, false, false}));
  EXPECT_EQ(plan.phases[2].touches, (std::vector<bool>{false, false, false, false}));
  const double weight_N = (7.6 + 3.89 + 0.05 + 0.91) * robot.tree.gravity_m_s2;
  for (const std::size_t p : {0, 1, 3}) {
    for (const PlannedInstant& at : plan.phases[p].instants) {
      EXPECT_NEAR(at.contact_N.row(2).sum(), weight_N, 1e-9);
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(at.contact_N(2, static_cast<Index>(i)) > 0.0, plan.phases[p].touches[i]);
      }
    }
  }
  EXPECT_EQ(plan.phases[2].instants[3].contact_N.norm(), 0.0);
}

TEST_F(WarmGuess, RefusesAMotionThatStandsOtherwise) {
  const std::string said = refusal({"flat", "flight", "flat"});
  EXPECT_NE(said.find("flat, heel, flight, flat"), std::string::npos) << said;
  EXPECT_NE(said.find("planned is flat, flight, flat"), std::string::npos) << said;
}

TEST_F(WarmGuess, RefusesAMotionThatLeavesThePlane) {
  motion.positions(1, 40) = 0.002;
  const std::string said = refusal(order);
  EXPECT_NE(said.find("leaves the sagittal plane"), std::string::npos) << said;
}

TEST_F(WarmGuess, RefusesAMotionWithoutABase) {
  motion.has_base = false;
  const std::string said = refusal(order);
  EXPECT_NE(said.find("no motion of the base"), std::string::npos) << said;
}

}  // namespace
}  // namespace torquewright::hopper
