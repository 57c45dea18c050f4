// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/run_trials.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "simulation/in_parallel.hpp"

namespace torquewright::hopper {
namespace {

/// Longer for some numbers, so that threads finish out of order.
TrialOutcome outcome_of(std::size_t number) {
  if (number % 5 == 0) std::this_thread::sleep_for(std::chrono::microseconds(300));
  TrialOutcome outcome;
  outcome.verdict = number % 3 == 0 ? ReplayVerdict::kFell : ReplayVerdict::kStands;
  outcome.end_time_s = static_cast<double>(number);
  return outcome;
}

// Oracle: the trial itself, asked for one number after the other.
TEST(RunTrials, AnswersInTheOrderOfNumbersWhateverTheThreads) {
  for (const std::size_t threads : {0u, 1u, 2u, 7u, 300u}) {
    const auto outcomes = run_trials({200, threads, {}, {}}, outcome_of);
    ASSERT_EQ(outcomes.size(), 200u);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      ASSERT_TRUE(outcomes[i]) << i;
      EXPECT_EQ(outcomes[i]->end_time_s, static_cast<double>(i));
      EXPECT_EQ(outcomes[i]->verdict, outcome_of(i).verdict);
    }
    const TrialCounts counts = counted(outcomes);
    EXPECT_EQ(counts.failed, 67u);  // 0, 3, ... 198
    EXPECT_EQ(counts.succeeded, 133u);
    EXPECT_EQ(counts.unfinished, 0u);
  }
}

TEST(RunTrials, TellsHowManyAreDone) {
  std::vector<std::size_t> told;
  (void)run_trials({50, 4, {}, [&](std::size_t done) { told.push_back(done); }}, outcome_of);
  std::vector<std::size_t> expected(50);
  std::iota(expected.begin(), expected.end(), 1);
  EXPECT_EQ(told, expected);
}

// What is done stays; what was not begun, and what its trial gave up, is unfinished.
TEST(RunTrials, KeepsWhatIsDoneWhenStopped) {
  for (const std::size_t threads : {1u, 4u}) {
    std::atomic<std::size_t> begun = 0;
    const auto stops = [&] { return begun >= 20; };
    const auto trial = [&](std::size_t number) {
      ++begun;
      TrialOutcome outcome = outcome_of(number);
      if (number == 2) outcome.verdict = ReplayVerdict::kUnfinished;
      return outcome;
    };
    const auto outcomes = run_trials({1000, threads, stops, {}}, trial);
    ASSERT_EQ(outcomes.size(), 1000u);
    const TrialCounts counts = counted(outcomes);
    EXPECT_EQ(counts.done(), begun - 1);
    EXPECT_EQ(counts.all(), 1000u);
    EXPECT_GE(begun, 20u);
    EXPECT_LT(begun, 20u + threads);
    if (threads > 1) continue;  // a thread may have been late for a low number
    for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(outcomes[i].has_value(), i < 20) << i;
  }
}

// A stop that was seen holds, also where the question is answered otherwise later.
TEST(RunTrials, AsksNoMoreOnceStopped) {
  int asked = 0;
  const auto outcomes = run_trials({10, 1, [&] { return ++asked == 4; }, {}}, outcome_of);
  EXPECT_EQ(asked, 4);
  EXPECT_EQ(counted(outcomes).done(), 3u);
}

// Of several failures the lowest number's, for any number of threads: whether that comes before or
// after the others.
TEST(InParallel, ThrowsTheLowestNumbersFailure) {
  for (int repeat = 0; repeat < 50; ++repeat) {
    for (const std::size_t threads : {1u, 2u, 4u}) {
      const auto work = [&](std::size_t number, std::size_t) {
        // Until the other threads are there.
        std::this_thread::sleep_for(std::chrono::microseconds(100));
        if (number < 6) return;
        const bool is_late = (number == 6) == (repeat % 2 == 0);
        if (is_late) std::this_thread::sleep_for(std::chrono::microseconds(300));
        throw std::runtime_error(std::to_string(number));
      };
      try {
        simulation::in_parallel(100, threads, work);
        FAIL() << "nothing was thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "6");
      }
    }
  }
}

TEST(InParallel, CallsEachNumberOnce) {
  std::vector<std::atomic<int>> calls(1000);
  simulation::in_parallel(1000, 5, [&](std::size_t number, std::size_t thread) {
    EXPECT_LT(thread, 5u);
    ++calls[number];
  });
  for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
  simulation::in_parallel(0, 3,
                          [](std::size_t, std::size_t) { FAIL() << "there is nothing to do"; });
  EXPECT_THROW(simulation::in_parallel(1, 0, [](std::size_t, std::size_t) {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::hopper
