// SPDX-License-Identifier: Apache-2.0
// Oracle: counting.
#include "learning/team.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace torquewright::learning {
namespace {

TEST(Team, DoesEveryPieceOnceRoundAfterRound) {
  Team team(3);
  std::vector<int> done(100, 0);
  for (int round = 1; round <= 200; ++round) {
    const int count = round % 100;
    team.run(count, [&](int number, int thread) {
      ASSERT_LT(thread, team.threads());
      ++done[static_cast<std::size_t>(number)];
    });
  }
  for (std::size_t i = 0; i < done.size(); ++i) EXPECT_EQ(done[i], 2 * (99 - static_cast<int>(i)));
}

TEST(Team, ThrowsOnTheFailureOfTheLowestNumberAndWorksOn) {
  Team team(2);
  for (int round = 0; round < 50; ++round) {
    try {
      team.run(20, [](int number, int) {
        if (number >= 5) throw std::runtime_error(std::to_string(number));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "5");
    }
    std::atomic<int> done = 0;
    team.run(20, [&](int, int) { ++done; });
    EXPECT_EQ(done, 20);
  }
}

}  // namespace
}  // namespace torquewright::learning
