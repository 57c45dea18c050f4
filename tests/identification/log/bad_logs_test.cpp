// SPDX-License-Identifier: Apache-2.0
// Faults of a log that show over many samples (docs/logs.md), put in by hand; the oracle is what
// was put in. Refusals that concern single cells stand in log_reader_test.cpp, units and signs in a
// file of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/log/stretch.hpp"
#include "tests/identification/log/made_log.hpp"
#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification {
namespace {

using test::MadeLog;
using test::read;
using test::ReadLog;

constexpr double kPi = std::numbers::pi;

const nlohmann::json kRig =
    test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}, {"i", "motor_current_A"}});

/// A swing of 0.7 Hz and the current that goes with it, 9 s at 200 Hz.
MadeLog swing() {
  return MadeLog(9.0, 200.0)
      .add("q", [](double t) { return 0.8 * std::sin(2 * kPi * 0.7 * t); })
      .add("i", [](double t) { return 3.0 * std::cos(2 * kPi * 0.7 * t + 0.3); });
}

/// The second is held out; an empty line at its end tells it from the first.
ReadLog read_two(const MadeLog& log) {
  return read({{"a.csv", log.text()}, {"b.csv", swing().text() + "\n"}}, kRig);
}

std::size_t masked(const Log& log) {
  std::size_t count = 0;
  for (const Run& run : log.runs) {
    count += static_cast<std::size_t>(std::count(run.masked.begin(), run.masked.end(), 1));
  }
  return count;
}

TEST(BadLog, AGoodOneHasNothingToSayButTheHoldout) {
  const ReadLog result = read_two(swing());
  ASSERT_EQ(result.refusal, "");
  ASSERT_EQ(result.log.findings.size(), 1u) << result.log.findings[0].sentence;
  EXPECT_NE(result.finding("names no holdout_runs").sentence, "");
  EXPECT_EQ(masked(result.log), 0u);
}

// Oracle: the angle before it was wrapped.
TEST(BadLog, WrappedAngleIsUnwrappedAndSaid) {
  const auto angle = [](double t) { return 7.0 * std::sin(2 * kPi * 0.2 * t) + 2.0 * t; };
  for (const bool from_zero : {false, true}) {
    MadeLog log = swing();
    std::vector<double>& q = log["q"];
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double whole = angle(static_cast<double>(i) / 200.0);
      const double within = std::remainder(whole, 2 * kPi);
      q[i] = from_zero && within < 0.0 ? within + 2 * kPi : within;
    }
    const ReadLog result = read_two(log);
    ASSERT_EQ(result.refusal, "");
    const auto& run = result.log.runs[0];
    const std::vector<double>& read_rad = run.joints[0][Quantity::kOutputPosition];
    for (std::size_t i = 0; i < read_rad.size(); ++i) {
      // 9 digits were written.
      ASSERT_NEAR(read_rad[i] - read_rad[0], angle(run.time_s[i]) - angle(0.0), 1e-7);
    }
    const DataFinding said = result.finding("unwrapped");
    EXPECT_EQ(said.weight, Weight::kNote);
    EXPECT_NE(said.sentence.find("output_position_rad: "), std::string::npos);
    EXPECT_NE(said.sentence.find("in run \"a\""), std::string::npos) << said.sentence;
    EXPECT_EQ(masked(result.log), 0u);
  }
}

TEST(BadLog, WrappedAngleThatTurnsTooFastIsRefused) {
  MadeLog log = swing();
  std::vector<double>& q = log["q"];
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = std::remainder(2.0 * static_cast<double>(i), 2 * kPi);  // 2 rad > pi/2 a sample
  }
  EXPECT_NE(read_two(log).refusal.find("more than a quarter of one between two samples"),
            std::string::npos);
}

// Oracle: the smooth curve that stood there.
TEST(BadLog, IsolatedImpossibleSamplesAreReplacedMaskedAndSaid) {
  MadeLog log = swing();
  const std::vector<double> whole = log["q"];
  log["q"][300] = 100.0;
  log["q"][700] = -0.9;
  log["q"][701] = -0.9;
  log["i"][1200] = -25.0;
  const ReadLog result = read_two(log);
  ASSERT_EQ(result.refusal, "");
  const auto& run = result.log.runs[0];
  for (const std::size_t i : {300u, 700u, 701u, 1200u}) EXPECT_EQ(run.masked[i], 1) << i;
  EXPECT_EQ(masked(result.log), 4u);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    // A chord over 3 samples: |q''| h^2 = 0.8 (2 pi 0.7)^2 (1/200)^2 = 4e-4 at most.
    ASSERT_NEAR(run.joints[0][Quantity::kOutputPosition][i], whole[i], 5e-4) << i;
  }
  EXPECT_NE(result.finding("output_position_rad: 3 impossible samples").sentence, "");
  EXPECT_EQ(result.finding("motor_current_A: 1 impossible sample that").weight, Weight::kWarning);
}

// A wrapped angle's faults are found on the circle: 5.3 rad off is 1 rad off the other way.
TEST(BadLog, IsolatedSamplesOfAWrappedAngleAreFound) {
  MadeLog log = swing();
  std::vector<double>& q = log["q"];
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = std::remainder(0.02 * static_cast<double>(i), 2 * kPi);
  }
  q[400] += q[400] > 0.0 ? -3.0 : 3.0;
  const ReadLog result = read_two(log);
  ASSERT_EQ(result.refusal, "");
  const std::vector<double>& read_rad = result.log.runs[0].joints[0][Quantity::kOutputPosition];
  for (std::size_t i = 0; i < read_rad.size(); ++i) {
    ASSERT_NEAR(read_rad[i], 0.02 * static_cast<double>(i), 1e-7);
  }
  EXPECT_EQ(masked(result.log), 1u);
}

TEST(BadLog, ManyThatLeaveAndReturnAreLeftAndSaid) {
  MadeLog log = swing();
  for (std::size_t i = 50; i < 1750; i += 60) log["q"][i] = 30.0;
  const ReadLog result = read_two(log);
  EXPECT_EQ(result.finding("too many to be single faults").weight, Weight::kWarning);
  EXPECT_EQ(masked(result.log), 0u);
  EXPECT_EQ(result.log.runs[0].joints[0][Quantity::kOutputPosition][50], 30.0);
}

// Oracle: the samples that were clipped, counted when they were.
TEST(BadLog, SaturatedChannelIsMaskedAndSaid) {
  MadeLog log = swing();
  std::size_t clipped = 0;
  for (double& i_A : log["i"]) {
    clipped += std::abs(i_A) > 2.4;
    i_A = std::clamp(i_A, -2.4, 2.4);
  }
  const ReadLog result = read_two(log);
  EXPECT_EQ(masked(result.log), clipped);
  EXPECT_NE(result.finding(fmt::format("motor_current_A: {} samples at the end", clipped)).sentence,
            "");
}

TEST(BadLog, GapIsCutAndSaid) {
  MadeLog log = swing();
  std::string text = log.text();
  const std::size_t from = text.find("\n3.000000"), to = text.find("\n3.500000");
  text.erase(from, to - from);
  const ReadLog result = read({{"a.csv", text}, {"b.csv", swing().text()}}, kRig);
  ASSERT_EQ(result.log.runs.size(), 3u);
  EXPECT_EQ(result.finding("run \"a\" has 1 gap in time, the longest 0.505 s").weight,
            Weight::kWarning);
}

TEST(BadLog, ConstantChannelIsSaid) {
  const nlohmann::json rig = test::rig_json({{"t", "time_s"},
                                             {"q", "output_position_rad"},
                                             {"i", "motor_current_A"},
                                             {"T", "case_temperature_K"}});
  MadeLog log(9.0, 200.0);
  log.add("q", [](double t) { return std::sin(t); })
      .add("i", [](double) { return 2.5; })
      .add("T", [](double) { return 300.0; });
  const ReadLog result = read({{"a.csv", log.text()}}, rig);
  EXPECT_EQ(result.finding("motor_current_A is 2.5 A all through").weight, Weight::kWarning);
  EXPECT_EQ(result.finding("case_temperature_K is 300 K all through").weight, Weight::kNote);
  EXPECT_EQ(result.finding("all through the log").sentence, "");  // two there are, none of q
}

// Just inside and just outside of 2 mrad.
TEST(BadLog, JointThatNeverMovesCannotTell) {
  for (const auto& [amplitude_rad, weight] : std::vector<std::pair<double, Weight>>{
           {0.00099, Weight::kError}, {0.00101, Weight::kNote}}) {
    MadeLog log = swing();
    for (double& q : log["q"]) q *= amplitude_rad / 0.8;
    const ReadLog result = read({{"a.csv", log.text()}}, kRig);
    EXPECT_EQ(result.finding("the joint never moves").weight, weight) << amplitude_rad;
  }
}

// Two runs; the second is held out. 3 s are needed to fit, 1.5 s to be held out.
TEST(BadLog, RunsShorterThanNeededCannotTell) {
  const auto run = [](double duration_s) {
    return MadeLog(duration_s + 0.001, 200.0)
        .add("q", [](double t) { return std::sin(9 * t); })
        .add("i", [](double t) { return std::cos(9 * t); })
        .text();
  };
  const auto read_runs = [&](double train_s, double holdout_s) {
    return read({{"a.csv", run(train_s)}, {"b.csv", run(holdout_s) + "\n"}}, kRig);
  };
  EXPECT_EQ(read_runs(3.1, 1.6).finding("the log cannot tell").sentence, "");
  EXPECT_EQ(read_runs(2.9, 1.6).finding("the runs to fit hold 2.9 s of use").weight,
            Weight::kError);
  const ReadLog short_holdout = read_runs(3.1, 1.4);
  EXPECT_EQ(short_holdout.finding("the runs held out hold 0 s of use").weight, Weight::kError);
  EXPECT_EQ(short_holdout.finding("1 stretch is shorter than 1.5 s").weight, Weight::kWarning);
}

TEST(BadLog, MapOfTooFewPointsCannotTell) {
  const nlohmann::json rig =
      test::rig_json({{"q", "motor_position_rad"}, {"i", "motor_current_A"}});
  const auto map = [](int count) {
    std::string text = "q,i\n";
    for (int i = 0; i < count; ++i) text += fmt::format("{},{}\n", 0.1 * i, std::sin(7 * 0.1 * i));
    return text;
  };
  const auto weight = [&](int count) {
    return read({{"a.csv", map(count)}, {"b.csv", map(40) + "\n"}}, rig)
        .finding("to fit hold")
        .weight;
  };
  EXPECT_EQ(weight(19), Weight::kError);
  EXPECT_EQ(weight(20), Weight::kNote);  // no finding
}

}  // namespace
}  // namespace torquewright::identification
