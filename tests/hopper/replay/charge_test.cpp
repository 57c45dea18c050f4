// SPDX-License-Identifier: Apache-2.0
// Oracle: a straight count of what cells hold.
#include "hopper/replay/charge.hpp"

#include <gtest/gtest.h>

#include "tests/hopper/replay/driven_robot.hpp"

namespace torquewright::hopper {
namespace {

/// Two strings of 0.01 Ah.
Robot on_small_battery() {
  actuator::Actuator drive = round_drive(0.1);
  drive.battery->cell_capacity_Ah = 0.01;
  drive.battery->parallel_cells = 2.0;
  return driven_robot({drive});
}

ReplayResult judged(ReplayVerdict verdict, double drawn_Ah,
                    const actuator::OperatingConditions& conditions = {}) {
  ReplayResult result;
  result.outcome.verdict = verdict;
  Record record;
  record.drawn_Ah = {drawn_Ah};
  judge_charge(on_small_battery(), conditions, record, result);
  return result;
}

TEST(ReplayCharge, MoreThanTheBatteryHoldsIsNotDone) {
  const ReplayResult held = judged(ReplayVerdict::kStands, 0.0199);
  EXPECT_EQ(held.outcome.verdict, ReplayVerdict::kStands);
  ASSERT_EQ(held.findings.size(), 1u);
  EXPECT_EQ(held.findings[0].severity, actuator::Severity::kNote);
  EXPECT_NEAR(*held.findings[0].limit, 0.02, 1e-15);
  const ReplayResult drained = judged(ReplayVerdict::kStands, 0.0201);
  EXPECT_EQ(drained.outcome.verdict, ReplayVerdict::kMissed);
  EXPECT_EQ(drained.findings[0].severity, actuator::Severity::kViolation);
  EXPECT_NE(drained.outcome.reason.find("0.0201 Ah, 100 % of what is in the battery of drive_1"),
            std::string::npos)
      << drained.outcome.reason;
  EXPECT_EQ(judged(ReplayVerdict::kFell, 0.0201).outcome.verdict, ReplayVerdict::kFell);
  actuator::OperatingConditions half;
  half.state_of_charge = 0.5;
  EXPECT_EQ(judged(ReplayVerdict::kStands, 0.0101, half).outcome.verdict, ReplayVerdict::kMissed);
}

TEST(ReplayCharge, OfABatteryThatIsChargedNothingIsSaid) {
  EXPECT_TRUE(judged(ReplayVerdict::kStands, -0.001).findings.empty());
}

}  // namespace
}  // namespace torquewright::hopper
