// SPDX-License-Identifier: Apache-2.0
// `ulimit -s`. A plan is what takes the most stack.
#include <gtest/gtest.h>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

Outcome plan_within(rlim_t limit_kB) {
  Workplace place;
  place.here.stack_limit = limit_kB * 1024;
  return place.run({"hopper", "flip", in_repository("specs/robot/hopper.json").string(), "-o",
                    "plan.csv", "--task", "jump", "--contacts", "flat,flight,flat", "--intervals",
                    "10", "--rounds", "0", "--iterations", "3", "--time-limit", "60"});
}

TEST(LimitedStack, OfHalfAMegabyteIsRefused) {
  const Outcome outcome = plan_within(512);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "ulimit -s: leaves less than 1024 KiB, too little; 8192 is usual\n");
}

// Sanitizers make frames larger.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(LimitedStack, OfAMegabyteHoldsThePlan) { EXPECT_EQ(plan_within(1024).exit_code, 3); }
#endif

}  // namespace
}  // namespace torquewright::cli_test
