// SPDX-License-Identifier: Apache-2.0
// Rows that a recorder wrote again while the joint moved on. Oracle: which rows were put in.
#include "identification/reading/stale_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification {
namespace {

using test::read;
using test::ReadLog;

const nlohmann::json kRig =
    test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}, {"i", "motor_current_A"}});

/// A swing at 100 Hz that says at some rows what it said `late` rows before the last fresh one.
std::string swing_with_holds(int first, int last) {
  std::string text = "t,q,i\n";
  for (int row = 0; row < 600; ++row) {
    const double said_s = 0.01 * (row >= first && row < last ? first - 1 : row);
    text += fmt::format("{},{:.6f},{:.4f}\n", 0.01 * row, std::sin(6.0 * said_s),
                        2.0 * std::cos(6.0 * said_s + 0.2));
  }
  return text;
}

std::size_t rows_of(const ReadLog& result) {
  std::size_t rows = 0;
  for (const Run& run : result.log.runs) rows += run.time_s.size();
  return rows;
}

TEST(StaleRows, AreLeftOutAndSaid) {
  const ReadLog result = read({{"a.csv", swing_with_holds(100, 103)}}, kRig);
  ASSERT_EQ(result.refusal, "");
  EXPECT_EQ(rows_of(result), 597u);
  for (const auto& run : result.log.runs) {
    for (std::size_t row = 0; row < run.time_s.size(); ++row) {
      EXPECT_NEAR(run.joints[0][Quantity::kOutputPosition][row], std::sin(6.0 * run.time_s[row]),
                  1e-6);
    }
  }
  EXPECT_NE(result.finding("3 rows that repeat the row before").sentence, "");
}

TEST(StaleRows, LongOnesLeaveAPause) {
  const ReadLog result = read({{"a.csv", swing_with_holds(100, 110)}}, kRig);
  ASSERT_EQ(result.refusal, "");
  EXPECT_NE(result.finding("10 rows that repeat the row before").sentence, "");
  EXPECT_NE(result.finding("pauses 1 time").sentence, "");
  EXPECT_EQ(result.log.runs.size(), 2u);  // the two thirds that are fitted, and the last
}

// Written at twice the rate at which it is measured. Few are not told: at even speed at first,
// while the position's resolution is not known, and where it turns back, at another pace.
TEST(StaleRows, AreEverySecondOfALogThatIsWrittenTwiceAsOften) {
  std::string text = "t,q,i\n";
  for (int row = 0; row < 1200; ++row) {
    const double said_s = 0.01 * (row / 2);
    text += fmt::format("{},{:.6f},{:.4f}\n", 0.005 * row, std::sin(0.4 * said_s),
                        2.0 * std::cos(0.4 * said_s));
  }
  const ReadLog result = read({{"a.csv", text}}, kRig);
  ASSERT_EQ(result.refusal, "");
  EXPECT_GE(rows_of(result), 601u);
  EXPECT_LE(rows_of(result), 640u);
}

// Stands still from 1 to 2 s: what it says then is true.
TEST(StaleRows, AreNoneAtRest) {
  std::string text = "t,q,i\n";
  for (int row = 0; row < 600; ++row) {
    const double t = row < 100 ? 0.01 * row : row < 200 ? 1.0 : 0.01 * (row - 100);
    const double angle = 2.0 * std::numbers::pi * t;
    text += fmt::format("{},{:.6f},{:.4f}\n", 0.01 * row,
                        t - std::sin(angle) / (2.0 * std::numbers::pi),
                        row < 100 || row >= 200 ? std::sin(angle) : 0.0);
  }
  const ReadLog result = read({{"a.csv", text}}, kRig);
  ASSERT_EQ(result.refusal, "");
  EXPECT_EQ(rows_of(result), 600u);
}

TEST(StaleRows, GoOnAsTheyCame) {
  const std::vector<double> time_s{0.0, 1.0, 2.0, 3.0}, moving{0.0, 1.0, 1.0, 1.0};
  const Travel travel{time_s, moving, 0.01};
  EXPECT_TRUE(are_stale(travel, 2, 4.0, 4.0));
  EXPECT_FALSE(are_stale(travel, 2, 4.0, 1.5));   // it had nearly stopped
  EXPECT_FALSE(are_stale(travel, 2, 4.0, -2.0));  // it turned back
  EXPECT_FALSE(are_stale(travel, 0, 4.0, 4.0));
  EXPECT_FALSE(are_stale({time_s, moving, 0.5}, 2, 4.0, 4.0));  // steps of its resolution
}

// An encoder of 0.1 that is read at even speed, and one that moves as it likes.
TEST(Resolution, IsWhatStepsDifferByLeast) {
  Resolution even, uneven;
  for (const double step : {0.7, 0.7, 0.6, 0.7}) even.add(step, 0.0);
  EXPECT_NEAR(even.least(), 0.1, 1e-12);
  for (const double step : {0.5, 0.30, 0.33}) uneven.add(step, 0.0);
  EXPECT_NEAR(uneven.least(), 0.03, 1e-12);
  EXPECT_EQ(Resolution().least(), 0.0);
  Resolution written;  // to 5 digits: 0.08789 and 0.08790 are one count
  for (const double step : {0.08789, 0.08790, 0.17578, 0.08789}) written.add(step, 1e-5);
  EXPECT_NEAR(written.least(), 0.08789, 2e-5);
}

/// Asked for at 350 Hz what is new at 50: both channels with noise, so that a row that repeats is
/// never rest. From `still_s` on nothing is new for two seconds.
std::string polled(double still_s) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, 1e-3);
  std::string text = "t,q,i\n", said;
  int last = -1;
  for (int row = 0; row < 4200; ++row) {
    const double t = row / 350.0;
    const int word = t < still_s || t >= still_s + 2.0 ? static_cast<int>(50.0 * t + 1e-6) : last;
    if (word != last) {
      const double said_s = 0.02 * word;
      said = fmt::format("{:.6f},{:.6f}", 0.2 * std::sin(0.8 * said_s) + noise(random),
                         std::cos(0.8 * said_s) + noise(random));
    }
    last = word;
    text += fmt::format("{:.6f},{}\n", t, said);
  }
  return text;
}

TEST(StaleRows, OfARecorderThatAsksTooSoonLeaveOneForEachWord) {
  const ReadLog result = read({{"a.csv", polled(1e9)}}, kRig);
  ASSERT_EQ(result.refusal, "");
  EXPECT_EQ(rows_of(result), 600u);
  EXPECT_NE(result.finding("come at an even pace, asked for too soon").sentence, "");
  EXPECT_EQ(result.finding("pauses").sentence, "");
  for (const auto& run : result.log.runs) {
    for (std::size_t row = 1; row < run.time_s.size(); ++row) {
      EXPECT_NEAR(run.time_s[row] - run.time_s[row - 1], 0.02, 1e-5);  // 1 step over 600 words
    }
  }
}

// Where nothing is new for long it is rest, which keeps rows: none is further than two words from
// the next.
TEST(StaleRows, OfARecorderThatAsksTooSoonKeepRest) {
  const ReadLog result = read({{"a.csv", polled(5.0)}}, kRig);
  ASSERT_EQ(result.refusal, "");
  EXPECT_GT(rows_of(result), 550u);
  EXPECT_EQ(result.finding("pauses").sentence, "");
}

// Oracle: the construction. Half of the time the joint moves and each row is new; then it rests,
// and only its temperature flickers, every third row: nothing was asked for too soon.
TEST(PolledRows, AreNotThoseOfAJointAtRest) {
  identification::Run run;
  run.joints.resize(1);
  for (int i = 0; i < 1200; ++i) {
    run.time_s.push_back(i % 3 == 0 ? 0.006 * i : 0.006 * i - 0.001);
    run.joints[0][Quantity::kOutputPosition].push_back(i < 600 ? 0.01 * i : 6.0);
    run.joints[0][Quantity::kCaseTemperature].push_back(i % 6 < 3 ? 300.0 : 301.0);
  }
  run.masked.assign(1200, 0);
  EXPECT_EQ(drop_polled(run), 0u);
  EXPECT_EQ(run.time_s.size(), 1200u);
}

}  // namespace
}  // namespace torquewright::identification
