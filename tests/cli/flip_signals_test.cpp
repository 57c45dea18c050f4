// SPDX-License-Identifier: Apache-2.0
// `hopper flip` gets signals at moments from its start to past its end: while it reads, plans,
// integrates, draws and writes; alone, and as a sweep with processes of its own. Oracles: what
// stood there before, what a whole run leaves, and the exit codes of docs/flip.md.
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/workplace.hpp"
#include "tests/long_run.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;
using std::chrono::microseconds;

/// From a run's start to its end.
const int kMoments = test::is_long_run() ? 5 : 3;
const std::string kHopper = in_repository("specs/robot/hopper.json").string();
/// A coarse jump that is found in a second.
const Words kJump{"hopper",   "flip",          kHopper,    "--task",
                  "jump",     "--intervals",   "20",       "--integration-error",
                  "0.1",      "--bus-voltage", "60",       "-o",
                  "plan.csv", "--write-best",  "best.csv", "--report",
                  "page.html"};
const Words kSweep{
    "hopper",   "flip", kHopper,        "--task", "jump",    "--intervals",        "10",
    "--rounds", "0",    "--iterations", "10",     "--sweep", "knee_ratio=14:24:2", "--jobs",
    "2",        "-o",   "flips.json"};

class FlipSignals : public testing::Test {
 protected:
  void lay_out(const Words& outputs) {
    for (const auto& entry : fs::directory_iterator(place_.path())) fs::remove(entry.path());
    for (const std::string& output : outputs) place_.write(output, "old");
  }
  microseconds duration_of(const Words& command) {
    const auto start = std::chrono::steady_clock::now();
    place_.here.signal.reset();
    const Outcome outcome = place_.run(command);
    EXPECT_NE(outcome.exit_code, 2) << outcome.err;
    return std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - start);
  }
  Outcome run(const Words& command, int signal, microseconds after) {
    place_.here.signal = Signal{signal, after};
    Outcome outcome = place_.run(command);
    EXPECT_TRUE(outcome.has_ended) << "signal " << signal;
    EXPECT_TRUE(outcome.exit_code >= 0 || outcome.signal == signal);
    return outcome;
  }
  bool is_old(const std::string& file) const { return place_.text(file) == "old"; }

  Workplace place_;
};

TEST_F(FlipSignals, LeaveWholeFilesOfAPlan) {
  const Words outputs{"plan.csv", "best.csv", "page.html"};
  lay_out(outputs);
  const microseconds whole_run = duration_of(kJump);
  const auto finished = place_.files();
  ASSERT_FALSE(is_old("plan.csv"));
  int ended_early = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    for (int i = 0; i < kMoments; ++i) {
      lay_out(outputs);
      const Outcome outcome = run(kJump, signal, whole_run * i / (kMoments - 1));
      EXPECT_EQ(place_.files().size(), outputs.size()) << "a temporary file is left";
      if (outcome.exit_code == 0) {
        EXPECT_EQ(place_.files(), finished);
      } else if (outcome.exit_code == 3 && signal == SIGINT) {
        ++ended_early;
        EXPECT_TRUE(is_old("plan.csv")) << "it is no plan";
        EXPECT_TRUE(place_.text("best.csv").starts_with("# ")) << "says that it is none";
        EXPECT_TRUE(place_.text("best.csv").ends_with("\n"));
        EXPECT_TRUE(place_.text("page.html").ends_with("</html>\n"));
      } else {
        EXPECT_EQ(outcome.exit_code, -1) << outcome.err;
        for (const std::string& output : outputs) {
          // Killed after the files were exchanged and before it could say so: all are new.
          EXPECT_TRUE(is_old(output) || place_.files() == finished) << output;
        }
      }
    }
  }
  EXPECT_GT(ended_early, 0);
}

/// Whole lines of JSON, but for the last, which may be half of one.
void expect_journal(const std::string& text) {
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  for (std::string line; std::getline(lines, line);) EXPECT_TRUE(json::accept(line)) << line;
}

TEST_F(FlipSignals, EndASweepAndItsProcesses) {
  lay_out({});
  const microseconds whole_run = duration_of(kSweep);
  const std::string finished = place_.text("flips.json");
  for (const int signal : {SIGINT, SIGTERM}) {
    for (int i = 0; i < kMoments; ++i) {
      lay_out({});
      const Outcome outcome = run(kSweep, signal, whole_run * i / (kMoments - 1));
      const std::string result = place_.text("flips.json");
      EXPECT_EQ(place_.files().size(), (place_.has("flips.json") ? 1u : 0u) +
                                           (place_.has("flips.json.journal") ? 1u : 0u));
      expect_journal(place_.text("flips.json.journal"));
      if (outcome.exit_code == 3 && signal == SIGINT) {
        EXPECT_TRUE(json::accept(result));
      } else {
        EXPECT_TRUE(result.empty() || result == finished);
      }
      // What it holds is gone on with.
      place_.here.signal.reset();
      if (i == kMoments / 2) {
        EXPECT_EQ(place_.run(kSweep).exit_code, 3);
        EXPECT_EQ(place_.text("flips.json"), finished);
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::cli_test
