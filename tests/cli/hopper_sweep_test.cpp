// SPDX-License-Identifier: Apache-2.0
// Sweeps as users start them. Oracle: the same commands with documents in which the swept value was
// written by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/documents/document.hpp"
#include "tests/cli/cut_journal.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class HopperSweep : public testing::Test {
 protected:
  HopperSweep() {
    fs::copy(in_repository("specs"), place_.path("specs"), fs::copy_options::recursive);
  }

  Outcome check(const Words& options, const std::string& motion = "squat") const {
    Words words{"hopper", "check", "specs/robot/hopper.json",
                "specs/trajectory/hopper_" + motion + ".csv"};
    words.insert(words.end(), options.begin(), options.end());
    return place_.run(words);
  }
  json swept(const Words& options, const std::string& motion = "squat") const {
    Words words = options;
    words.push_back("--json");
    const Outcome outcome = check(words, motion);
    EXPECT_EQ(outcome.err, "");
    const json result = json::parse(outcome.out);
    EXPECT_NO_THROW(io::check_document(result, "sweep_result", "result", ""));
    return result;
  }
  /// What the plain check says of the robot with another text in one of its documents.
  json edited(const std::string& file, const std::string& from, const std::string& to,
              const std::string& motion) const {
    const std::string before = place_.text(file);
    place_.write(file, with(before, from, to));
    const json report = json::parse(check({"--json", "--torques", "dynamics"}, motion).out);
    place_.write(file, before);
    return report;
  }
  static void expect_same(const json& point, const json& report) {
    EXPECT_EQ(point["status"], report["verdict"]);
    double least_Nm = 1e9;
    for (const json& joint : report["joints"]) {
      const std::string binding = point["binding"];
      if (!binding.starts_with(joint["name"].get<std::string>() + ":")) continue;
      least_Nm = std::min(least_Nm, joint["margin_Nm"].get<double>());
    }
    const double margin_Nm = point["measures"]["margin_Nm"];
    EXPECT_NEAR(margin_Nm, least_Nm, 1e-9 * std::abs(least_Nm));
    for (const json& bus : report["buses"]) {
      const double least_V = bus["least_V"];
      EXPECT_NEAR(point["measures"]["least_bus_V"].get<double>(), least_V, 1e-9 * least_V);
    }
  }
  void expect_refusal(const Words& options, const std::string& sentence) const {
    const Outcome outcome = check(options);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }

  Workplace place_;
};

TEST_F(HopperSweep, ChecksEveryRobotAsIfItsDocumentsSaidSo) {
  const json result = swept({"--sweep", "knee_ratio=12,16,20"}, "flip");
  EXPECT_EQ(result["axes"][0]["present"], 20);
  const char* file = "specs/actuator/d151_knee.json";
  expect_same(result["points"][0], edited(file, "\"ratio\": 20", "\"ratio\": 12", "flip"));
  expect_same(result["points"][1], edited(file, "\"ratio\": 20", "\"ratio\": 16", "flip"));
  expect_same(result["points"][2], edited(file, "\"ratio\": 20", "\"ratio\": 20", "flip"));
}

// 16 cells: 3.3 V each are 52.8 V.
TEST_F(HopperSweep, ChecksAtOtherVoltages) {
  const json result = swept({"--sweep", "voltage=52.8"});
  expect_same(result["points"][0], edited("specs/robot/hopper.json", "\"cell_open_circuit_V\": 4.2",
                                          "\"cell_open_circuit_V\": 3.3", "squat"));
}

TEST_F(HopperSweep, SaysTheSameByAnyNumberOfProcesses) {
  const Words sweep{"--sweep", "knee_current=5:50:15", "--sweep", "voltage=20,67.2"};
  const std::string alone = swept(sweep).dump();
  for (const char* jobs : {"1", "2", "3"}) {
    Words by_jobs = sweep;
    by_jobs.insert(by_jobs.end(), {"--jobs", jobs});
    EXPECT_EQ(swept(by_jobs).dump(), alone) << jobs;
  }
}

TEST_F(HopperSweep, GoesOnWhereItsJournalEnds) {
  expect_goes_on(place_, 0, [this] {
    return check({"--sweep", "mass_factor=0.8:1.2:0.2", "-o", "result.json"});
  });
}

// Another motion is another request: nothing of the journal is its own.
TEST_F(HopperSweep, TakesNothingOfOtherInputs) {
  const Words sweep{"--sweep", "knee_ratio=16", "--sweep-journal", "journal"};
  check(sweep);
  const std::string once = place_.text("journal");
  check(sweep, "flip");
  const std::string twice = place_.text("journal");
  EXPECT_EQ(std::count(twice.begin(), twice.end(), '\n'), 3);
  EXPECT_TRUE(twice.starts_with(once));
}

TEST_F(HopperSweep, DrawsAChartAndAMap) {
  ASSERT_EQ(check({"--sweep", "knee_ratio=10:30:10", "--plot-sweep", "chart.svg"}).exit_code, 0);
  EXPECT_TRUE(place_.text("chart.svg").find("knee_ratio") != std::string::npos);
  ASSERT_EQ(check({"--sweep", "knee_ratio=10:30:10", "--sweep", "voltage=10,30", "--plot-sweep",
                   "map.svg"})
                .exit_code,
            0);
  const std::string map = place_.text("map.svg");
  EXPECT_TRUE(map.find("voltage in V") != std::string::npos);
  EXPECT_TRUE(map.find("margin_share") != std::string::npos);
}

TEST_F(HopperSweep, DrawsOnePoint) {
  const Outcome chart = check({"--sweep", "knee_ratio=20", "--plot-sweep", "chart.svg"});
  EXPECT_EQ(chart.exit_code, 0) << chart.err;
  EXPECT_NE(place_.text("chart.svg").find("</svg>"), std::string::npos);
  const Outcome map =
      check({"--sweep", "knee_ratio=20", "--sweep", "voltage=60", "--plot-sweep", "map.svg"});
  EXPECT_EQ(map.exit_code, 0) << map.err;
}

TEST_F(HopperSweep, ListsEveryPointInWords) {
  const Outcome outcome = check({"--sweep", "voltage=8,67.2"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("2 points, 1 pass, 1 fail\n"), std::string::npos) << outcome.out;
}

TEST_F(HopperSweep, FailsWhereNothingPasses) {
  EXPECT_EQ(check({"--sweep", "voltage=8,9"}).exit_code, 1);
}

TEST_F(HopperSweep, IsRefused) {
  expect_refusal({"--sweep", "hip_ratio=8"}, "knee_ratio");
  expect_refusal({"--sweep", "ratio=8"}, "name one");
  expect_refusal({"--sweep", "knee_ratio=0:8:1"}, "not above 0");
  expect_refusal({"--sweep", "knee_ratio=8:4:1"}, "lies above");
  expect_refusal({"--sweep", "knee_ratio=8", "--sweep", "ratio_factor=2"}, "same drives");
  expect_refusal({"--sweep", "voltage=48", "--bus-voltage", "60"}, "one sets the other");
  expect_refusal({"--sweep", "knee_ratio=8", "--series", "s.csv"}, "is of one robot");
  for (const char* option : {"--plot", "--plot-loads", "--plot-momentum", "--figures"}) {
    expect_refusal({"--sweep", "knee_ratio=8", option, "x.svg"}, "is of one robot");
  }
  expect_refusal({"--sweep", "knee_ratio=8", "--torques", "file"}, "--torques");
  expect_refusal({"--sweep", "knee_ratio=8", "-o", "specs/robot/hopper.json"}, "is an input");
  expect_refusal({"--sweep", "knee_ratio=8", "--sweep-journal", "specs/actuator/d151_knee.json"},
                 "cannot be written");
  expect_refusal({"--sweep", "knee_ratio=8", "--plot-sweep", "a.gif"}, ".svg or .png");
  expect_refusal({"--jobs", "2"}, "is for --sweep or --candidates");
  EXPECT_EQ(place_.text("specs/actuator/d151_knee.json"),
            text_of(in_repository("specs/actuator/d151_knee.json")));
}

TEST_F(HopperSweep, TriesCandidatesByProcessesAsByThreads) {
  const Words candidates{"--candidates", "specs/actuator", "--ratios", "10:20:10", "--json"};
  const std::string by_threads = check(candidates, "flip").out;
  Words by_jobs = candidates;
  by_jobs.insert(by_jobs.end(), {"--jobs", "2"});
  EXPECT_EQ(check(by_jobs, "flip").out, by_threads);
  EXPECT_FALSE(json::parse(by_threads)["candidates"].empty());
}

TEST_F(HopperSweep, RunsTrialsByProcessesAsByThreads) {
  const Words trials{"hopper",
                     "replay",
                     "specs/robot/hopper.json",
                     "specs/trajectory/hopper_squat.csv",
                     "--trials",
                     "3",
                     "--randomise",
                     "specs/randomisation/hopper.json",
                     "--until",
                     "0.3",
                     "--stand",
                     "0.05",
                     "--json"};
  const std::string by_threads = place_.run(trials).out;
  Words by_jobs = trials;
  by_jobs.insert(by_jobs.end(), {"--jobs", "2", "--sweep-journal", "journal"});
  EXPECT_EQ(place_.run(by_jobs).out, by_threads);
  EXPECT_EQ(place_.run(by_jobs).out, by_threads);  // from the journal
  EXPECT_EQ(json::parse(by_threads)["trials"]["list"].size(), 3u);
}

}  // namespace
}  // namespace torquewright::cli_test
