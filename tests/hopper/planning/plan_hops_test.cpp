// SPDX-License-Identifier: Apache-2.0
// Hops in a row and over a step of the ground. Oracles: `hopper check` of the motion; kinematics of
// its samples, against the speed, the strides and the ground that were asked for; replays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dynamics/point.hpp"
#include "hopper/motion/further_hops.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/hopper/planning/planned.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kHopPlace_m = 1e-6;
constexpr double kHopSpeed_m_s = 0.8;
constexpr double kHopStep_m = 0.085;
constexpr double kHopEdge_m = 0.02;

PlanOptions two_hops() {
  PlanOptions options;
  options.task = &tasks::hop;
  options.repeat = 2;
  options.speed_m_s = kHopSpeed_m_s;
  options.landings_m = {0.0, kHopStep_m};
  options.margins.edge_m = kHopEdge_m;
  options.intervals = 50;
  return options;
}

const PlanResult& planned_hops() {
  static const PlanResult hops = plan_motion(test::hopper_robot_of_plans(), two_hops());
  return hops;
}

Vector3d place_of(const Motion& motion, Index sample, const dynamics::BodyPoint& point) {
  dynamics::TreeState state(test::hopper_robot_of_plans().tree);
  state.set(motion.positions.col(sample), motion.velocities.col(sample));
  return dynamics::point_position_m(state, point);
}

Index sample_at(const Motion& motion, double time_s) {
  const auto found = std::lower_bound(motion.times_s.begin(), motion.times_s.end(), time_s - 1e-9);
  return static_cast<Index>(found - motion.times_s.begin());
}

TEST(PlannedHops, KeepToSpeedStridesAndStepAndTheCheckPassesThem) {
  const Robot& robot = test::hopper_robot_of_plans();
  const PlanResult& hops = planned_hops();
  ASSERT_EQ(hops.status, PlanStatus::kPlanned) << hops.reason;
  EXPECT_EQ(test::checked(robot, hops).check.verdict, actuator::Verdict::kPass);
  std::vector<const PlannedPhase*> flights;
  for (const PlannedPhase& phase : hops.plan.phases) {
    if (phase.flies()) flights.push_back(&phase);
  }
  ASSERT_EQ(flights.size(), 2u);
  const double way_m = test::moved_m(robot, hops, 0).x();
  EXPECT_NEAR(way_m, kHopSpeed_m_s * (flights[1]->end_s() - flights[0]->begin_s()), kHopPlace_m);
  EXPECT_NEAR(test::moved_m(robot, hops, 0).z(), kHopStep_m, kHopPlace_m);
  const dynamics::BodyPoint& heel = robot.contacts.front().point;
  const Vector3d first = place_of(hops.motion, 0, heel);
  const Vector3d between =
      place_of(hops.motion, sample_at(hops.motion, flights[1]->begin_s() - 0.12),
               heel);  // toes push for less
  EXPECT_NEAR(between.x() - first.x(), 0.5 * way_m, kHopPlace_m);
  EXPECT_NEAR(between.z(), first.z(), kHopPlace_m);
}

/// Places of the sole from heel to toe, at every sample.
std::vector<Vector3d> places_of_the_sole(const Motion& motion) {
  const Robot& robot = test::hopper_robot_of_plans();
  const dynamics::BodyPoint &heel = robot.contacts[0].point, &toe = robot.contacts[2].point;
  std::vector<Vector3d> places;
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    const Vector3d rear = place_of(motion, sample, heel), front = place_of(motion, sample, toe);
    for (int i = 0; i <= 40; ++i) places.push_back(rear + i / 40.0 * (front - rear));
  }
  return places;
}

// The corner is no place of the sole: 2 mm are what the check takes for rounding.
TEST(PlannedHops, NoPartOfTheSoleGoesThroughTheGround) {
  const PlanResult& hops = planned_hops();
  ASSERT_EQ(hops.status, PlanStatus::kPlanned) << hops.reason;
  const simulation::GroundProfile& ground = hops.motion.ground;
  ASSERT_EQ(ground.heights_m, (std::vector<double>{0.0, kHopStep_m}));
  double least_m = 1.0, highest_m = 0.0;
  for (const Vector3d& at : places_of_the_sole(hops.motion)) {
    least_m = std::min(least_m, at.z() - ground.height_m(at.x()));
    highest_m = std::max(highest_m, ground.height_m(at.x()));
  }
  EXPECT_GT(least_m, -2e-3);
  EXPECT_EQ(highest_m, kHopStep_m);
}

// Within the 5 mm on either side that count as the edge, and by no more than the plan has to.
TEST(PlannedHops, TheSolePassesTheEdgeAsHighAsIsAskedFor) {
  const PlanResult& hops = planned_hops();
  ASSERT_EQ(hops.status, PlanStatus::kPlanned) << hops.reason;
  double least_m = 1.0;
  for (const Vector3d& at : places_of_the_sole(hops.motion)) {
    if (std::abs(at.x() - hops.motion.ground.edges_x_m.front()) > 5e-3) continue;
    least_m = std::min(least_m, at.z() - kHopStep_m);
  }
  EXPECT_GT(least_m, kHopEdge_m - 2e-3);
  EXPECT_LT(least_m, kHopEdge_m + 10e-3);
}

TEST(PlannedHops, StandWhenTheyAreReplayed) {
  ASSERT_EQ(planned_hops().status, PlanStatus::kPlanned);
  for (const EngineKind* engine : {&engines::own, &engines::mujoco}) {
    if (engine->absence != nullptr && engine->absence()) continue;
    const ReplayResult run = test::replayed(test::hopper_robot_of_plans(), planned_hops(), *engine);
    EXPECT_EQ(run.outcome.verdict, ReplayVerdict::kStands) << run.outcome.reason;
    EXPECT_EQ(run.outcome.landings.size(), 2u);
  }
}

// Oracles: the samples' kinematics, and `hopper check` of a motion of six hops, most of which no
// programme has seen.
TEST(PlannedHops, ThatAreAlikeGoOnAtTheirSpeed) {
  constexpr double kAlikeSpeed_m_s = -0.4;
  constexpr double kTakeOff_m = 1e-5;  // ten times the solver's tolerance on postures, at a metre
  PlanOptions options;
  options.task = &tasks::hop;
  options.repeat = 2;
  options.has_alike_hops = true;
  options.speed_m_s = kAlikeSpeed_m_s;
  options.intervals = 16;
  options.most_error_rad = 0.02;
  const Robot& robot = test::hopper_robot_of_plans();
  const PlanResult two = plan_motion(robot, options);
  ASSERT_EQ(two.status, PlanStatus::kPlanned) << two.reason;
  Motion six = with_flights(robot, two.motion, 6);
  const double hop_s = (six.duration_s() - two.motion.duration_s()) / 4.0;
  const double way_m =
      six.positions(0, six.samples() - 1) - two.motion.positions(0, two.motion.samples() - 1);
  EXPECT_NEAR(way_m, 4.0 * hop_s * kAlikeSpeed_m_s, 4.0 * kTakeOff_m);
  const HopperReport report = check_motion(robot, six, {});
  EXPECT_EQ(report.check.verdict, actuator::Verdict::kPass);
  EXPECT_EQ(report.flights.size(), 6u);
}

TEST(PlannedHops, StepsWithoutRoomAreRefusedByName) {
  const auto refused = [](const auto& change) {
    PlanOptions options = two_hops();
    change(options);
    try {
      (void)plan_motion(test::hopper_robot_of_plans(), options);
    } catch (const io::SpecError& error) {
      return std::string(error.what());
    }
    return std::string("planned");
  };
  const auto says = [&](const std::string& words, const auto& change) {
    const std::string said = refused(change);
    EXPECT_NE(said.find("--land-at"), std::string::npos) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  says("a --stride of 0.27 m or more, and it is 0.2 m",
       [](PlanOptions& options) { options.stride_m = 0.2; });
  says("of 3 landings, and there are 2", [](PlanOptions& options) {
    options.landings_m = {0.0, 0.1, 0.2};
  });
  says("needs a 'flat' between", [](PlanOptions& options) {
    options.stances = {"flat", "toe", "flight", "toe", "flight", "toe", "flat"};
  });
}

}  // namespace
}  // namespace torquewright::hopper
