// SPDX-License-Identifier: Apache-2.0
// Oracle: which of the two keys are stated.
#include "actuator/lint/idle_limit.hpp"

#include <gtest/gtest.h>

#include "actuator/lint/examination.hpp"
#include "actuator/motor/actuator.hpp"
#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

Actuator drive_with(bool regeneration, double limit_W) {
  Actuator document = sample();
  document.drive.regeneration = regeneration;
  document.drive.regeneration_limit_W = limit_W;
  return document;
}

TEST(IdleRegenerationLimit, IsNoted) {
  std::vector<Finding> notes;
  for (const Finding& each : examine(drive_with(false, 500.0)).findings) {
    if (each.rule == "idle-regeneration-limit") notes.push_back(each);
  }
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes.front().severity, Severity::kNote);
  EXPECT_EQ(notes.front().sentence,
            "/drive/regeneration_limit_W says 500 (499.5 to 500.5) W, and /drive/regeneration says "
            "that no power flows back: the limit is ignored; state one of them.");
}

TEST(IdleRegenerationLimit, IsNoneWhereItCountsOrIsNotStated) {
  EXPECT_FALSE(idle_regeneration_limit(drive_with(true, 500.0)).has_value());
  EXPECT_FALSE(idle_regeneration_limit(drive_with(false, kUnlimited)).has_value());
  EXPECT_FALSE(idle_regeneration_limit(sample()).has_value());
}

}  // namespace
}  // namespace torquewright::actuator::lint
