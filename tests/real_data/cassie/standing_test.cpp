// SPDX-License-Identifier: Apache-2.0
// Cassie stands under operational-space control, its drives held to their regions. Oracle: two
// engines that have no line in common, and the posture in which it is to stay.
#include <gtest/gtest.h>

#include <memory>

#include "hopper/engines/every_engine.hpp"
#include "hopper/replay/replay.hpp"
#include "hopper/tracking/operational/tasks_spec.hpp"
#include "tests/real_data/cassie/cassie.hpp"
#include "tests/real_data/cassie/cassie_jump.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kStand_s = 0.5;
constexpr double kWatched_s = 0.3;

class CassieStands : public testing::TestWithParam<const EngineKind*> {};

TEST_P(CassieStands, UnderItsDrivesRegions) {
  if (test::cassie_file().empty() || test::published_jump_file().empty()) {
    GTEST_SKIP() << "needs the maker's model and its published jump, ../shared/data";
  }
  if (GetParam()->absence != nullptr) {
    if (const auto absent = GetParam()->absence()) GTEST_SKIP() << *absent;
  }
  const Robot robot = test::cassie();
  Motion motion =
      test::standing_motion(robot, test::read_jump(test::published_jump_file()), kStand_s);
  CheckOptions check;
  check.residual_share = 2.0;  // springs are rigid in the motion: what they need is left
  const HopperReport report = check_motion(robot, motion, check);
  ReplayOptions options;
  options.engine = GetParam();
  options.controller = &controllers::osc;
  options.impact.handling = ImpactHandling::kDefault;
  options.clock.resynchronise = false;
  options.run.stand_s = kWatched_s;
  options.tasks = std::make_shared<const OperationalTasks>(
      read_tasks(TORQUEWRIGHT_SOURCE_DIR "/specs/controller/cassie.json", robot).tasks);
  const ReplayedRun done = Replay(robot, motion, report, options).run({});
  ASSERT_FALSE(done.record.rows.empty());
  EXPECT_NEAR(done.result.outcome.end_s, kStand_s + kWatched_s, 1e-3) << done.result.outcome.reason;
  EXPECT_EQ(done.result.account.unsolved, 0);
  for (const RecordRow& row : done.record.rows) {
    const Eigen::VectorXd off = row.position - motion.positions.leftCols<1>();
    ASSERT_LE(off.head<3>().norm(), 0.02) << "base, m, at " << row.time_s << " s";
    ASSERT_LE(2.0 * row.position.segment<3>(4).norm(), 0.05) << "turned, rad, at " << row.time_s;
  }
  EXPECT_LE(done.record.rows.back().velocity.norm(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Engines, CassieStands, testing::Values(&engines::own, &engines::mujoco),
                         [](const auto& one) { return std::string(one.param->name); });

}  // namespace
}  // namespace torquewright::hopper
