// SPDX-License-Identifier: Apache-2.0
// Oracle: the same runs in memory, and sorting of all values.
#include "identification/log/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "identification/log/largest_values.hpp"
#include "identification/log/piece.hpp"
#include "identification/log/run_groups.hpp"
#include "identification/log/spread_runs.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::identification::runs_test {
namespace {

/// Samples number `begin` to before `end` of a line q = 2 t.
Run line(const std::string& name, int begin, int end, bool continues = false) {
  Run run;
  run.name = name;
  run.joints.resize(2);
  for (int i = begin; i < end; ++i) {
    run.time_s.push_back(0.1 * i);
    run.joints[1][Quantity::kOutputPosition].push_back(0.2 * i);
    run.masked.push_back(i % 3 == 0);
  }
  run.continues = continues;
  return run;
}

void expect_same(const Run& a, const Run& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.masked, b.masked);
  EXPECT_EQ(a.continues, b.continues);
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t j = 0; j < a.joints.size(); ++j) EXPECT_EQ(a.joints[j].of, b.joints[j].of);
}

void expect_same(const Runs& a, const Runs& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.rows(), b.rows());
  for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
  std::size_t seen = 0;
  for (const auto& run : a) expect_same(run, b[seen++]);
  EXPECT_EQ(seen, b.size());
}

Runs filled(std::size_t most_rows) {
  Runs runs(most_rows);
  runs.push_back(line("a", 0, 10));
  runs.push_back(line("a", 10, 25, true));
  runs.push_back(line("b", 0, 7));
  return runs;
}

TEST(Runs, GoToAFileBeyondTheirRows) {
  EXPECT_TRUE(filled(32).is_in_memory());
  EXPECT_FALSE(filled(31).is_in_memory());
  EXPECT_FALSE(filled(5).is_in_memory());
}

TEST(Runs, OfAFileAreTheSame) {
  expect_same(filled(5), filled(100));
  expect_same(filled(31), filled(100));
}

TEST(Runs, TellTheirHeadsAndChannelsWithoutBeingRead) {
  for (const std::size_t most : {5u, 100u}) {
    const Runs runs = filled(most);
    EXPECT_EQ(runs.head(1).samples, 15u);
    EXPECT_DOUBLE_EQ(runs.head(1).begin_s, 1.0);
    EXPECT_DOUBLE_EQ(runs.head(1).end_s, 2.4);
    EXPECT_TRUE(runs.head(1).continues);
    EXPECT_TRUE(runs.has(1, Quantity::kOutputPosition));
    EXPECT_FALSE(runs.has(0, Quantity::kOutputPosition));
    EXPECT_FALSE(runs.has(1, Quantity::kMotorCurrent));
  }
}

// Changes of the same length, of another, of the channels there are, of names, and in between.
TEST(Runs, AreChangedAlike) {
  const auto changed = [](std::size_t most) {
    Runs runs = filled(most);
    runs.change(0, [](auto& run) { run.joints[1][Quantity::kOutputPosition][3] = 99.0; });
    runs.change(1, [](auto& run) { run = line("longer", 0, 40, true); });
    runs.change(2, [](auto& run) { run.joints[1][Quantity::kOutputPosition].clear(); });
    runs.rename(0, "other");
    runs.insert(1, line("between", 3, 5));
    runs.cut_before(2);
    return runs;
  };
  const Runs file = changed(5), memory = changed(1000);
  EXPECT_FALSE(file.is_in_memory());
  expect_same(file, memory);
  EXPECT_EQ(file[0].joints[1][Quantity::kOutputPosition][3], 99.0);
  EXPECT_FALSE(file.head(2).continues);
}

TEST(Runs, CopiesDoNotSeeEachOthersChanges) {
  const Runs first = filled(5);
  Runs second = first;
  second.change(0, [](auto& run) { run.time_s.back() = 0.95; });
  EXPECT_DOUBLE_EQ(first[0].time_s.back(), 0.9);
  EXPECT_DOUBLE_EQ(second[0].time_s.back(), 0.95);
}

TEST(Runs, JoinTheirPieces) {
  Runs runs = filled(100);
  runs.join_pieces();
  ASSERT_EQ(runs.size(), 2u);
  expect_same(runs[0], line("a", 0, 25));
  expect_same(runs[1], line("b", 0, 7));
}

TEST(Piece, HasItsNeighboursOfTheSameStretchAlone) {
  for (const std::size_t most : {5u, 100u}) {
    const Runs runs = filled(most);
    const Piece first = with_neighbours(runs, 0, 4), second = with_neighbours(runs, 1, 4),
                other = with_neighbours(runs, 2, 4);
    expect_same(first.run, line("a", 0, 14));
    EXPECT_EQ(first.begin, 0u);
    EXPECT_EQ(first.end, 10u);
    EXPECT_EQ(second.run.time_s, line("a", 6, 25).time_s);
    EXPECT_EQ(second.begin, 4u);
    EXPECT_EQ(second.end, 19u);
    expect_same(other.run, line("b", 0, 7));
    EXPECT_EQ(with_neighbours(runs, 0, 50).run.masked.size(), 25u);
  }
}

TEST(SpreadRuns, AreAllOfWhatIsInMemory) {
  EXPECT_EQ(spread_runs(filled(100)), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(SpreadRuns, LieEvenlyOverALongLog) {
  Runs runs(100);
  for (int i = 0; i < 50; ++i) runs.push_back(line("run", 0, 10));
  const std::vector<std::size_t> chosen = spread_runs(runs);
  ASSERT_EQ(chosen.size(), 10u);
  for (std::size_t k = 0; k < chosen.size(); ++k) EXPECT_EQ(chosen[k] / 5, k);  // one of each five
}

TEST(SpreadRuns, HoldNoMoreRowsThanMemoryMay) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    Runs runs(300);
    for (int i = 0; i < 40; ++i)
      runs.push_back(line("run", 0, 2 + static_cast<int>(random() % 40)));
    std::size_t rows = 0, longest = 0;
    for (const std::size_t i : spread_runs(runs)) rows += runs.head(i).samples;
    for (std::size_t i = 0; i < runs.size(); ++i) longest = std::max(longest, runs.head(i).samples);
    EXPECT_LE(rows, 300 + longest / 2 + 1);
    EXPECT_GE(rows + longest / 2 + 1, 300);
  }
}

TEST(LargestValues, GiveTheQuantilesOfAllValues) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (const std::size_t count : {1u, 2u, 3u, 37u, 1000u, 20001u}) {
    std::vector<double> all(count);
    for (double& value : all) value = std::round(20.0 * normal(random));  // with ties
    for (const double share : {0.998, 0.999, 1.0}) {
      LargestValues largest(count + 7, 0.998);
      for (const double value : all) largest.add(value);
      EXPECT_EQ(largest.quantile(share), optimization::nearest_quantile(all, share))
          << count << " " << share;
    }
  }
}

TEST(LargestValues, RefuseWhatTheyDidNotKeep) {
  LargestValues largest(1000, 0.99);
  for (int i = 0; i < 1000; ++i) largest.add(i);
  EXPECT_THROW(largest.quantile(0.5), std::logic_error);
}

/// So many runs, the last third held out.
Log many(std::size_t count, std::size_t most_rows) {
  Log log{Runs(most_rows), {}, {}, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    log.runs.push_back(line(std::to_string(i), 0, 2));
    (3 * i < 2 * count ? log.train_runs : log.holdout_runs).push_back(std::to_string(i));
  }
  return log;
}

TEST(RunGroups, AreTheRunsWhereThereAreFew) {
  for (const std::size_t most : {10u, 100000u}) {
    const std::vector<RunGroup> groups = run_groups(many(300, most));
    for (std::size_t i = 0; i < groups.size(); ++i) {
      EXPECT_EQ(groups[i].is_held_out, i >= 200);
      EXPECT_EQ(groups[i].number, i < 200 ? i : i - 200);
    }
  }
}

TEST(RunGroups, AreOfOneNameWhateverPieces) {
  Log log{filled(5), {"b"}, {"a"}, {}, {}};
  const std::vector<RunGroup> groups = run_groups(log);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_TRUE(groups[0].is_held_out && groups[1].is_held_out && !groups[2].is_held_out);
  EXPECT_EQ(groups[0].number, groups[1].number);
}

TEST(RunGroups, JoinNeighboursOfOneKindInALongLog) {
  const std::vector<RunGroup> groups = run_groups(many(3000, 10));
  EXPECT_EQ(runs_per_group(many(3000, 10)), 7.5);
  EXPECT_EQ(groups[1999].number, 266u);  // 2000 runs of 7.5: none without a run
  EXPECT_EQ(groups[2999].number, 133u);
  for (std::size_t i = 1; i < groups.size(); ++i) {
    EXPECT_EQ(groups[i].is_held_out, i >= 2000);
    if (i == 2000) continue;
    EXPECT_LE(groups[i].number - groups[i - 1].number, 1u);
  }
  EXPECT_EQ(run_groups(many(3000, 100000))[1999].number, 1999u);  // a short one: never
}

}  // namespace
}  // namespace torquewright::identification::runs_test
