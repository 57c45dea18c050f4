// SPDX-License-Identifier: Apache-2.0
// Oracle: the same log read as a whole. Faults lie at the cuts between pieces and beside them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numbers>

#include "identification/reading/log_reader.hpp"
#include "identification/reading/read_log.hpp"
#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification::long_logs_test {
namespace {

using test::read;
using test::ReadLog;

constexpr std::size_t kPiece = LogReader::kPieceRows;
constexpr std::size_t kRows = 3 * kPiece + 1234;
constexpr std::size_t kShort = 50000;  ///< Less than the log holds.
constexpr double kStep_s = 0.001;

const nlohmann::json kRig = test::rig_json({{"t", "time_s"},
                                            {"q", "output_position_rad"},
                                            {"w", "output_velocity_rad_s"},
                                            {"i", "motor_current_A"},
                                            {"run", "run"}});

/// A joint that turns on and on; what it shows is `spoilt` by sample.
std::string text(const std::function<void(std::size_t, double&, double&)>& spoilt,
                 std::size_t rows = kRows, const std::string& run = "all",
                 const std::function<double(std::size_t)>& later_s = {}) {
  std::string text = "t,q,w,i,run\n";
  for (std::size_t k = 0; k < rows; ++k) {
    const double t_s = kStep_s * static_cast<double>(k) + (later_s ? later_s(k) : 0.0);
    double angle_rad = 1.5 * t_s + 0.8 * std::sin(2.0 * t_s);
    double current_A =
        5.0 * std::sin(3.0 * t_s) + 1e-3 * std::sin(1e4 * static_cast<double>(k * k));
    spoilt(k, angle_rad, current_A);
    text += fmt::format("{:.3f},{:.9f},{:.6f},{:.6f},{}\n", t_s, angle_rad,
                        1.5 + 1.6 * std::cos(2.0 * t_s), current_A, run);
  }
  return text;
}

/// As read() does, with a limit of rows in memory.
Log read_with(const std::string& text, std::size_t most_rows) {
  const test::ScratchFolder folder;
  return read_log({folder.write("log.csv", text)}, test::rig_of(kRig), most_rows);
}

void nothing(std::size_t, double&, double&) {}

/// All samples of a channel, and of the mask, of the runs of one name.
struct Whole {
  std::vector<double> angle_rad, current_A, masked, time_s;

  Whole(const Log& log, const std::string& name) {
    for (const Run& run : log.runs) {
      if (run.name != name) continue;
      const auto add = [](std::vector<double>& all, const auto& more) {
        all.insert(all.end(), more.begin(), more.end());
      };
      add(angle_rad, run.joints[0][Quantity::kOutputPosition]);
      add(current_A, run.joints[0][Quantity::kMotorCurrent]);
      add(masked, run.masked);
      add(time_s, run.time_s);
    }
  }
};

void expect_same(const Log& pieces, const Log& whole) {
  EXPECT_FALSE(pieces.runs.is_in_memory());
  EXPECT_TRUE(whole.runs.is_in_memory());
  EXPECT_EQ(pieces.runs.rows(), whole.runs.rows());
  EXPECT_EQ(pieces.train_runs, whole.train_runs);
  EXPECT_EQ(pieces.holdout_runs, whole.holdout_runs);
  for (const auto* names : {&whole.train_runs, &whole.holdout_runs}) {
    for (const std::string& name : *names) {
      const Whole a(pieces, name), b(whole, name);
      EXPECT_EQ(a.time_s, b.time_s);
      EXPECT_EQ(a.current_A, b.current_A);
      EXPECT_EQ(a.masked, b.masked);
      ASSERT_EQ(a.angle_rad.size(), b.angle_rad.size());
      for (std::size_t k = 0; k < a.angle_rad.size(); ++k) {
        ASSERT_NEAR(a.angle_rad[k], b.angle_rad[k], 1e-9) << name << " " << k;
      }
    }
  }
}

/// But for the one that says that the log is long.
void expect_same_findings(const Log& pieces, const Log& whole) {
  std::vector<std::string> a, b;
  for (const DataFinding& each : pieces.findings) {
    if (each.sentence.find("not kept in memory") == std::string::npos) a.push_back(each.sentence);
  }
  for (const DataFinding& each : whole.findings) b.push_back(each.sentence);
  EXPECT_EQ(a, b);
  EXPECT_EQ(pieces.findings.size(), whole.findings.size() + 1);
}

TEST(LongLog, HoldsEveryRowOnceAndHoldsOutTheSame) {
  const std::string log = text(nothing);
  const Log pieces = read_with(log, kShort), whole = read_with(log, kLongestWholeLog);
  expect_same(pieces, whole);
  expect_same_findings(pieces, whole);
  ASSERT_GE(pieces.runs.size(), 4u);
  std::size_t begins = 0;
  for (const auto& run : pieces.runs) {
    EXPECT_LT(run.masked.size(), 2 * kPiece);
    begins += !run.continues;
  }
  EXPECT_EQ(begins, 2u);  // The log's, and that of what is held out.
}

TEST(LongLog, SaysWhatWasUsedForWhat) {
  const Log log = read_with(text(nothing), kShort);
  const auto words = [&](const char* part) {
    return std::any_of(log.findings.begin(), log.findings.end(), [&](const DataFinding& each) {
      return each.sentence.find(part) != std::string::npos;
    });
  };
  EXPECT_TRUE(words("the log holds 91234 rows; more than 50000 are not kept in memory"));
  EXPECT_TRUE(words("evenly spread"));
}

// The first and the last sample of a piece, and others.
TEST(LongLog, IsolatedSamplesAreFoundAtTheCutsToo) {
  const std::string log = text([](std::size_t k, double&, double& current_A) {
    for (const std::size_t at : {500ul, kPiece, 2 * kPiece - 1, 2 * kPiece + 700}) {
      if (k == at) current_A += 40.0;
    }
  });
  const Log pieces = read_with(log, kShort), whole = read_with(log, kLongestWholeLog);
  expect_same(pieces, whole);
  expect_same_findings(pieces, whole);
  const Whole all(pieces, whole.train_runs.front());
  EXPECT_EQ(all.masked[kPiece], 1.0);
  EXPECT_EQ(all.masked[2 * kPiece - 1], 1.0);
}

// Turns go on from piece to piece, also through one in which the joint stands and none begins.
TEST(LongLog, WrappedAnglesAreJoinedThroughAllPieces) {
  const std::string log = text([](std::size_t k, double& angle_rad, double&) {
    const std::size_t stop = kPiece / 2, start = 2 * kPiece + kPiece / 2;
    const std::size_t moved = k < stop ? k : k < start ? stop : k - (start - stop);
    angle_rad = std::remainder(0.01 * static_cast<double>(moved), 2.0 * std::numbers::pi);
  });
  const Log pieces = read_with(log, kShort), whole = read_with(log, kLongestWholeLog);
  expect_same(pieces, whole);
  expect_same_findings(pieces, whole);
  const Whole last(pieces, whole.holdout_runs.front());
  EXPECT_NEAR(last.angle_rad.back(), 0.01 * static_cast<double>(kRows - 1 - 2 * kPiece), 1e-6);
}

TEST(LongLog, GapsAreFoundInEveryPiece) {
  const auto gaps = [](std::size_t k) { return k >= kPiece + 20000 ? 0.5 : 0.0; };
  const std::string log = text(nothing, kRows, "all", gaps);
  const Log pieces = read_with(log, kShort), whole = read_with(log, kLongestWholeLog);
  expect_same(pieces, whole);
  expect_same_findings(pieces, whole);
}

TEST(LongLog, NeedsAFolderThatTmpdirNames) {
  const test::ScratchFolder folder;
  const std::filesystem::path log = folder.write("log.csv", text(nothing));
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "/tmp" : before;
  ::setenv("TMPDIR", "/absent", 1);
  try {
    read_log({log}, test::rig_of(kRig), kShort);
    ADD_FAILURE() << "is read";
  } catch (const std::exception& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("TMPDIR: a long log is held in the folder"))
        << error.what();
  }
  ::setenv("TMPDIR", kept.c_str(), 1);
}

}  // namespace
}  // namespace torquewright::identification::long_logs_test
