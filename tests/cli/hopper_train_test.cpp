// SPDX-License-Identifier: Apache-2.0
// `hopper train` and `hopper replay` of what it wrote: files, exit codes, the same bytes again, and
// refusals. Oracle: equality, and what the documents say.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/documents/document.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* kBriefTask = R"({"kind": "training_task", "version": 1, "name": "brief",
  "duration_s": 0.5, "goal": {"rests": true}, "scale_rad": 0.1,
  "full_torque_error_rad": 2, "rewards": [{"term": "alive"}, {"term": "fall", "weight": -10}],
  "learning": {"copies": 4, "steps": 50, "minibatch": 100, "layers": [16], "first_deviation": 0.1,
    "least_deviation": 0.05}})";

class HopperTrain : public testing::Test {
 protected:
  HopperTrain() { place_.write("brief.json", kBriefTask); }

  Outcome train(const std::string& policy, const Words& options) const {
    Words words{"hopper",
                "train",
                in_repository("specs/robot/hopper.json").string(),
                "--task",
                "brief.json",
                "-o",
                policy,
                "--judge-every",
                "2",
                "--judge-runs",
                "2"};
    words.insert(words.end(), options.begin(), options.end());
    return place_.run(words);
  }

  Outcome replay(const Words& options) const {
    Words words{"hopper", "replay"};
    words.insert(words.end(), options.begin(), options.end());
    return place_.run(words);
  }

  Workplace place_;
};

// With targets about the posture that it stands in, small actions leave it standing.
TEST_F(HopperTrain, NamesTheTaskThatMayBeMeant) {
  const Outcome outcome =
      place_.run({"hopper", "train", in_repository("specs/robot/hopper.json").string(), "--task",
                  "flop", "-o", "flop.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "flop: no file, and no task of that name; did you mean flip?\n");
  EXPECT_FALSE(place_.has("flop.json"));
}

TEST_F(HopperTrain, WritesAPolicyThatAReplayJudges) {
  const Outcome trained = train("stand.json", {"--iterations", "2", "--curve", "curve.csv"});
  EXPECT_EQ(trained.exit_code, 0) << trained.out << trained.err;
  EXPECT_EQ(trained.err, "");
  EXPECT_NE(trained.out.find("2 of 2 runs"), std::string::npos) << trained.out;
  const json policy = json::parse(place_.text("stand.json"));
  EXPECT_NO_THROW(io::check_document(policy, "policy", "stand.json", ""));
  EXPECT_EQ(policy["task"], "brief");
  EXPECT_EQ(policy["limits"], "mor");
  const std::string curve = place_.text("curve.csv");
  EXPECT_EQ(std::count(curve.begin(), curve.end(), '\n'), 3);
  for (const char* engine : {"own", "mujoco"}) {
    const Outcome judged = replay({in_repository("specs/robot/hopper.json").string(), "stand.json",
                                   "--engine", engine, "--json"});
    if (judged.exit_code == 2) continue;  // built without MuJoCo
    EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.err;
    const json report = json::parse(judged.out);
    EXPECT_NO_THROW(io::check_document(report, "replay_report", "report", ""));
    EXPECT_EQ(report["controller"], "policy");
    EXPECT_EQ(report["verdict"], "stands");
  }
}

TEST_F(HopperTrain, GoesOnToTheSameBytes) {
  EXPECT_NE(train("whole.json", {"--iterations", "4", "--curve", "whole.csv"}).exit_code, 2);
  EXPECT_NE(train("part.json", {"--iterations", "2", "--curve", "part.csv"}).exit_code, 2);
  EXPECT_NE(train("part.json", {"--iterations", "2", "--curve", "part.csv", "--resume"}).exit_code,
            2);
  EXPECT_TRUE(place_.text("part.csv") == place_.text("whole.csv"));
  EXPECT_TRUE(place_.text("part.json.training") == place_.text("whole.json.training"));
  EXPECT_TRUE(place_.text("part.json") == place_.text("whole.json"));
}

// The hand-made flip flies from 0.641 to 1.134 s, worked out apart from its rows, which are 2 ms
// apart; control periods are of 10 ms.
TEST_F(HopperTrain, GoesAlongAMotionToTheSameBytes) {
  place_.write("along.json", R"({"kind": "training_task", "version": 1, "name": "along",
    "duration_s": 1.6, "phase": {"take_off_s": 0.5, "landing_s": 1, "end_s": 1.5},
    "goal": {"turn_rad": 6.283, "least_flights": 1}, "scale_rad": 0.1, "full_torque_error_rad": 2,
    "rewards": [{"term": "follow"}, {"term": "fall", "weight": -10}], "learning": {"copies": 4,
      "steps": 50, "minibatch": 100, "layers": [16], "first_deviation": 0.1,
      "least_deviation": 0.05}})");
  const auto along = [this](const std::string& policy, const Words& more) {
    Words words{"hopper",
                "train",
                in_repository("specs/robot/hopper.json").string(),
                "--task",
                "along.json",
                "--reference",
                in_repository("specs/trajectory/hopper_flip.csv").string(),
                "-o",
                policy,
                "--judge-every",
                "1",
                "--judge-runs",
                "1"};
    words.insert(words.end(), more.begin(), more.end());
    return place_.run(words);
  };
  EXPECT_EQ(along("whole.json", {"--iterations", "3"}).exit_code, 3);
  EXPECT_EQ(along("part.json", {"--iterations", "2", "--threads", "2"}).exit_code, 3);
  EXPECT_EQ(along("part.json", {"--iterations", "1", "--resume"}).exit_code, 3);
  EXPECT_TRUE(place_.text("part.json.training") == place_.text("whole.json.training"));
  EXPECT_TRUE(place_.text("part.json") == place_.text("whole.json"));
  const json policy = json::parse(place_.text("whole.json"));
  EXPECT_NEAR(policy["training_task"]["phase"]["take_off_s"], 0.641, 2e-3);
  EXPECT_NEAR(policy["training_task"]["phase"]["landing_s"], 1.134, 2e-3);
  EXPECT_NEAR(policy["training_task"]["duration_s"], 1.734, 2e-3);
  EXPECT_EQ(policy["outputs"][0]["course"].size(), 174U);  // of the 1.7339 s that it lasts
  EXPECT_EQ(policy["outputs"][0]["offset"], 0.0);
  const Outcome judged =
      replay({in_repository("specs/robot/hopper.json").string(), "whole.json", "--json"});
  EXPECT_EQ(json::parse(judged.out)["verdict"], "fell");
}

TEST_F(HopperTrain, AnotherRobotsPolicyIsRefusedByNameAndOtherDrivesAreSaid) {
  ASSERT_EQ(train("stand.json", {"--iterations", "2"}).exit_code, 0);
  const Outcome leg = replay({in_repository("specs/robot/planar_leg.json").string(), "stand.json"});
  EXPECT_EQ(leg.exit_code, 2);
  EXPECT_NE(leg.err.find("ankle_pitch"), std::string::npos) << leg.err;
  // One digit of the robot's document changed.
  json policy = json::parse(place_.text("stand.json"));
  std::string digest = policy["trained_with"][1]["sha256"];
  digest[0] = digest[0] == 'a' ? 'b' : 'a';
  policy["trained_with"][1]["sha256"] = digest;
  place_.write("other.json", policy.dump());
  const Outcome other = replay({in_repository("specs/robot/hopper.json").string(), "other.json"});
  EXPECT_NE(other.out.find("[policy-drives]"), std::string::npos) << other.out;
  const Outcome boxed =
      replay({in_repository("specs/robot/hopper.json").string(), "stand.json", "--limits", "box"});
  EXPECT_NE(boxed.out.find("[policy-limits]"), std::string::npos) << boxed.out;
}

TEST_F(HopperTrain, RefusesWhatCannotBe) {
  const auto says = [this](const Words& words, const char* what) {
    const Outcome outcome = place_.run(words);
    EXPECT_EQ(outcome.exit_code, 2) << what;
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
  };
  const std::string robot = in_repository("specs/robot/hopper.json").string();
  says({"hopper", "train", robot}, "--output");
  says({"hopper", "train", robot, "-o", "p.json", "--task", "flap"}, "flap");
  place_.write("odd.json",
               with(kBriefTask, "\"first_deviation\": 0.1", "\"first_deviation\": 0.01"));
  says({"hopper", "train", robot, "-o", "p.json", "--task", "odd.json"}, "odd.json");
  says({"hopper", "train", robot, "-o", "p.json", "--task", "brief.json", "--resume"},
       "p.json.training");
  says({"hopper", "train", in_repository("specs/robot/rabbit.json").string(), "-o", "p.json"}, "");
  says({"hopper", "train", robot, "-o", "p.json", "--curriculum"}, "--randomise");
  says({"hopper", "train", robot, "-o", "p.json", "--task", "flip_along"},
       "--reference: is missing: the task flip_along follows a motion (/rewards/0)");
  const std::string squat = in_repository("specs/trajectory/hopper_squat.csv").string();
  says({"hopper", "train", robot, "-o", "p.json", "--reference", squat}, "never leaves the ground");
  says({"hopper", "replay", robot, in_repository("specs/trajectory/hopper_squat.csv").string(),
        "--forward", "1"},
       "--forward");
}

}  // namespace
}  // namespace torquewright::cli_test
