// SPDX-License-Identifier: Apache-2.0
// More threads asked for than the system gives: the work is done by those that there are. Oracle:
// the answer of one thread.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

Outcome run_with_threads(Words command, const std::string& threads, bool is_limited) {
  Workplace place;
  if (is_limited) {
    place.here.environment = {std::string("LD_PRELOAD=") + TORQUEWRIGHT_THREAD_LIMIT_STAND_IN,
                              // which asks to come first, and is found behind it
                              "ASAN_OPTIONS=exitcode=99:verify_asan_link_order=0"};
  }
  command.insert(command.end(), {"--threads", threads});
  return place.run(command);
}

void expect_the_same(const Words& command) {
  const Outcome alone = run_with_threads(command, "1", false);
  const Outcome limited = run_with_threads(command, "64", true);
  EXPECT_EQ(limited.exit_code, alone.exit_code) << limited.err;
  EXPECT_NE(alone.out, "");
  EXPECT_EQ(limited.out, alone.out);
}

TEST(ThreadLimit, LeavesTheRankingOfCandidates) {
  expect_the_same({"hopper", "check", in_specs("robot/hopper.json"),
                   in_specs("trajectory/hopper_squat.csv"), "--candidates", in_specs("actuator"),
                   "--ratios", "8:9"});
}

TEST(ThreadLimit, LeavesTheTrialsOfAReplay) {
  expect_the_same({"hopper", "replay", in_specs("robot/hopper.json"),
                   in_specs("trajectory/hopper_squat.csv"), "--step", "0.0005", "--stand", "0",
                   "--until", "0.05", "--trials", "4", "--randomise",
                   in_specs("randomisation/hopper.json")});
}

}  // namespace
}  // namespace torquewright::cli_test
