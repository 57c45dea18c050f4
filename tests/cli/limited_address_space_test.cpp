// SPDX-License-Identifier: Apache-2.0
// `ulimit -v` where the system's linear algebra is OpenBLAS, which hangs where it finds no room.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/workplace.hpp"

// Sanitizers reserve terabytes.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace torquewright::cli_test {
namespace {

const std::vector<std::string> kUsualCommand{
    "actuator", "mor", in_repository("specs/actuator/d151_knee.json").string(), "--at-speed", "0"};

Outcome run_beside_openblas(rlim_t limit_MB) {
  Workplace place;
  place.here.memory_limit = limit_MB * 1'000'000;
  place.here.environment = {std::string("LD_PRELOAD=") + TORQUEWRIGHT_OPENBLAS_STAND_IN};
  return place.run(kUsualCommand);
}

TEST(LimitedAddressSpace, OfTwoHundredMegabytesIsRefused) {
  const Outcome outcome = run_beside_openblas(200);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("ulimit -v: leaves less than 320 MiB beside the program"))
      << outcome.err;
}

// The buffers of two threads are more than that. Oracle: the answer without a limit.
TEST(LimitedAddressSpace, OfFourHundredMegabytesHoldsOneThread) {
  const Outcome outcome = run_beside_openblas(420);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, Workplace().run(kUsualCommand).out);
}

}  // namespace
}  // namespace torquewright::cli_test

#endif
