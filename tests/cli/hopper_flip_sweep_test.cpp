// SPDX-License-Identifier: Apache-2.0
// Sweeps of the planner as users start them. Oracle: the same command with documents in which the
// swept value was written by hand. Searches are cut short by iterations, which are the same on
// every machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/documents/document.hpp"
#include "tests/cli/cut_journal.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class HopperFlipSweep : public testing::Test {
 protected:
  HopperFlipSweep() {
    fs::copy(in_repository("specs"), place_.path("specs"), fs::copy_options::recursive);
  }

  Outcome jump(const Words& options) const {
    Words words{"hopper", "flip", "specs/robot/hopper.json", "--task", "jump", "--intervals", "20"};
    words.insert(words.end(), options.begin(), options.end());
    return place_.run(words);
  }
  /// Ended after three iterations: every point is a limit, after a moment.
  Outcome cut_short(const Words& options) const {
    Words words{"--iterations", "3"};
    words.insert(words.end(), options.begin(), options.end());
    return jump(words);
  }
  void expect_refusal(const Words& options, const std::string& sentence) const {
    const auto before = place_.files();
    const Outcome outcome = jump(options);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_EQ(place_.files(), before);
  }

  Workplace place_;
};

TEST_F(HopperFlipSweep, PlansForEveryRobotAsIfItsDocumentsSaidSo) {
  const Outcome outcome = jump({"--sweep", "knee_ratio=16,20", "--json"});
  EXPECT_EQ(outcome.err, "");
  const json swept = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(swept, "sweep_result", "result", ""));
  EXPECT_EQ(swept["command"], "hopper flip");
  EXPECT_EQ(swept["options"]["task"], "jump");
  const char* file = "specs/actuator/d151_knee.json";
  place_.write(file, with(place_.text(file), "\"ratio\": 20", "\"ratio\": 16"));
  const char* robot = "specs/robot/hopper.json";  // whose knee is limited by its drive
  place_.write(robot,
               with(place_.text(robot), "\"speed_limit_rad_s\": 10, \"torque_limit_Nm\": 320",
                    "\"speed_limit_rad_s\": 12.5, \"torque_limit_Nm\": 256"));
  const Outcome by_hand = jump({"-o", "plan.csv", "--json"});
  const json report = json::parse(by_hand.out);
  const json& point = swept["points"][0];
  ASSERT_EQ(report["status"], "planned") << by_hand.out.substr(0, 400);
  EXPECT_EQ(by_hand.exit_code, 0);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(point["status"], "planned");
  EXPECT_EQ(point["verdict"], "pass");
  // Another ratio by a factor of 16/20 may differ from 16 as written by a rounding, which the
  // solver's iterations amplify up to its tolerance, 1e-6 of scaled rows.
  EXPECT_NEAR(point["measures"]["cam_kg_m2_s"].get<double>(), report["cam_kg_m2_s"].get<double>(),
              1e-5);
  double flight_s = 0.0;
  for (const json& phase : report["phases"]) {
    if (phase["stance"] != "flight") continue;
    flight_s = phase["end_s"].get<double>() - phase["begin_s"].get<double>();
  }
  EXPECT_NEAR(point["measures"]["flight_s"].get<double>(), flight_s, 1e-5);
  EXPECT_GT(flight_s, 0.0);
  // Another robot, another answer.
  EXPECT_NE(swept["points"][1]["measures"]["margin_share"], point["measures"]["margin_share"]);
}

TEST_F(HopperFlipSweep, SaysTheSameByAnyNumberOfProcesses) {
  const Words sweep{"--sweep", "knee_ratio=16:20:2", "--sweep", "voltage=50,60", "--json"};
  const Outcome alone = cut_short(sweep);
  EXPECT_EQ(alone.exit_code, 3) << alone.err;
  const json result = json::parse(alone.out);
  EXPECT_EQ(result["points"].size(), 6u);
  for (const json& point : result["points"]) {
    EXPECT_EQ(point["verdict"], "undecided");
    EXPECT_NE(point["why"], "");
    for (const json& measure : point["measures"]) EXPECT_TRUE(measure.is_null()) << "no plan";
  }
  for (const char* jobs : {"1", "3"}) {
    Words by_jobs = sweep;
    by_jobs.insert(by_jobs.end(), {"--jobs", jobs});
    EXPECT_EQ(cut_short(by_jobs).out, alone.out) << jobs;
  }
}

TEST_F(HopperFlipSweep, GoesOnWhereItsJournalEnds) {
  expect_goes_on(place_, 3, [this] {
    return cut_short({"--sweep", "mass_factor=0.8:1.2:0.2", "-o", "result.json"});
  });
}

// Another task is another request: nothing of the journal is its own.
TEST_F(HopperFlipSweep, TakesNothingOfAnotherTask) {
  const Words sweep{"--sweep", "knee_ratio=16", "--sweep-journal", "journal"};
  cut_short(sweep);
  Words hop = sweep;
  hop.insert(hop.end(), {"--limits", "box"});
  cut_short(hop);
  const std::string journal = place_.text("journal");
  EXPECT_EQ(std::count(journal.begin(), journal.end(), '\n'), 3);
}

// Oracle: `hopper flip` and `hopper replay` of the robot whose document has that ratio.
TEST_F(HopperFlipSweep, TriesEachPlanAsItsReplayDoes) {
  const Words trials{"--trials", "4", "--randomise", "specs/randomisation/hopper.json"};
  Words sweep{"--sweep", "knee_ratio=18,20", "--trial-seed", "7", "--controller", "pd", "--json"};
  sweep.insert(sweep.end(), trials.begin(), trials.end());
  const Outcome outcome = jump(sweep);
  const json swept = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(swept, "sweep_result", "result", ""));
  EXPECT_EQ(swept["options"]["trials"], 4);
  EXPECT_EQ(swept["options"]["controller"], "pd");
  const char* file = "specs/actuator/d151_knee.json";
  place_.write(file, with(place_.text(file), "\"ratio\": 20", "\"ratio\": 18"));
  const char* robot = "specs/robot/hopper.json";
  place_.write(robot,
               with(place_.text(robot), "\"speed_limit_rad_s\": 10, \"torque_limit_Nm\": 320",
                    "\"speed_limit_rad_s\": 11.11111111111111, \"torque_limit_Nm\": 288"));
  const json plan = json::parse(jump({"-o", "plan.csv", "--json"}).out);
  ASSERT_EQ(plan["status"], "planned");
  Words replay{"hopper", "replay",       robot, "plan.csv", "--seed",
               "7",      "--controller", "pd",  "--json"};
  replay.insert(replay.end(), trials.begin(), trials.end());
  const json by_hand = json::parse(place_.run(replay).out)["trials"];
  ASSERT_EQ(by_hand["count"], 4);
  const json& measures = swept["points"][0]["measures"];
  EXPECT_EQ(measures["success_share"], by_hand["succeeded"].get<double>() / 4.0);
  EXPECT_EQ(measures["success_least"], by_hand["interval"][0]);
  EXPECT_EQ(measures["success_most"], by_hand["interval"][1]);
  EXPECT_NEAR(measures["objective"].get<double>(), plan["objective"].get<double>(), 1e-5);
  EXPECT_EQ(swept["points"][0]["why"] == "", by_hand["succeeded"] == 4);
}

// Oracle: the plan that it writes, replayed by hand with the draws that chose it and with fresh
// ones.
TEST_F(HopperFlipSweep, ChoosesAReserveByTrials) {
  const std::string drawn = "specs/randomisation/hopper.json";
  const Words robust{"--robust", drawn, "--trials", "3", "--controller", "pd", "--json"};
  Words asked{"--reserve", "0.08", "-o", "plan.csv"};
  asked.insert(asked.end(), robust.begin(), robust.end());
  const Outcome outcome = jump(asked);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json plan = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(plan, "plan_report", "report", ""));
  const json& choice = plan["robust"];
  EXPECT_EQ(plan["reserve"]["value"], choice["chosen"]);
  EXPECT_EQ(choice["tried"][0]["reserve"], 0.08);
  const auto by_hand = [&](const char* seed) {
    return json::parse(
        place_
            .run({"hopper", "replay", "specs/robot/hopper.json", "plan.csv", "--randomise", drawn,
                  "--trials", "3", "--controller", "pd", "--seed", seed, "--json"})
            .out)["trials"]["succeeded"];
  };
  for (const json& one : choice["tried"]) {
    if (one["reserve"] != choice["chosen"]) continue;
    EXPECT_EQ(one["trials"]["succeeded"], by_hand("1"));
  }
  EXPECT_EQ(choice["fresh_seed"], 2);
  EXPECT_EQ(choice["fresh"]["succeeded"], by_hand("2"));
}

// A point without a plan has nothing to try.
TEST_F(HopperFlipSweep, TriesNoMotionThatIsNoPlan) {
  const Outcome outcome = cut_short({"--sweep", "knee_ratio=20", "--trials", "2", "--randomise",
                                     "specs/randomisation/hopper.json", "--json"});
  const json point = json::parse(outcome.out)["points"][0];
  EXPECT_EQ(point["status"], "limit");
  EXPECT_TRUE(point["measures"]["success_share"].is_null());
  EXPECT_NE(point["why"], "");
}

TEST_F(HopperFlipSweep, IsRefused) {
  for (const auto& [option, file] : {std::pair<const char*, const char*>{"--write-best", "b.csv"},
                                     {"--figures", "figures.svg"},
                                     {"--report", "page.html"},
                                     {"--plot-momentum", "momentum.svg"}}) {
    expect_refusal({"--sweep", "knee_ratio=16", option, file}, "is of one robot");
  }
  expect_refusal({"--sweep", "knee_ratio=16", "--explain"}, "is of one robot");
  expect_refusal({"--sweep", "knee_ratio=16", "--timing"}, "is of one robot");
  expect_refusal({"--sweep", "hip_ratio=16"}, "knee_ratio");
  expect_refusal({"--sweep", "voltage=48", "--bus-voltage", "60"}, "one sets the other");
  expect_refusal({"-o", "plan.csv", "--jobs", "2"}, "is for --sweep");
  expect_refusal({"-o", "plan.csv", "--trials", "2"}, "is for --robust and --sweep");
  const std::string drawn = "specs/randomisation/hopper.json";
  expect_refusal({"-o", "plan.csv", "--robust", drawn}, "--trials");
  expect_refusal({"-o", "plan.csv", "--robust", "no.json", "--trials", "2"}, "no.json");
  expect_refusal({"-o", "plan.csv", "--robust", drawn, "--trials", "2", "--randomise", drawn},
                 "leave out --randomise");
  expect_refusal({"-o", "plan.csv", "--robust", drawn, "--trials", "2", "--explain"},
                 "leave out one of them");
  expect_refusal({"-o", "plan.csv", "--robust", drawn, "--trials", "2", "--report", drawn}, drawn);
  expect_refusal({"--sweep", "knee_ratio=16", "--robust", drawn, "--trials", "2"},
                 "is of one robot");
  expect_refusal({"--sweep", "knee_ratio=16", "--trials", "2"}, "needs --randomise FILE");
  expect_refusal({"--sweep", "knee_ratio=16", "--controller", "pd"}, "--trials");
  expect_refusal({"-o", "plan.csv", "--sweep-journal", "journal"}, "is for --sweep");
}

}  // namespace
}  // namespace torquewright::cli_test
