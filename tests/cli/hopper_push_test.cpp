// SPDX-License-Identifier: Apache-2.0
// `hopper replay --push`: what it says, trials under it, and refusals.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/documents/document.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class HopperPush : public testing::Test {
 protected:
  Outcome run(const Words& options) const {
    Words words{"hopper",
                "replay",
                in_repository("specs/robot/hopper.json"),
                in_repository("specs/trajectory/hopper_squat.csv"),
                "--step",
                "0.0005"};
    words.insert(words.end(), options.begin(), options.end());
    return place_.run(words);
  }

  Workplace place_;
};

// 300 N s are 24 m/s of its 12.45 kg.
TEST_F(HopperPush, AStandingRobotBearsAPuffAndNotABlow) {
  const Outcome puff = run({"--push", "0.05@0.5", "--push", "calf:0,0,0.02@0.7"});
  EXPECT_EQ(puff.exit_code, 0) << puff.out;
  EXPECT_NE(puff.out.find("pushed by (0.05, 0, 0) N s on thigh at t = 0.5000 s"), std::string::npos)
      << puff.out;
  EXPECT_NE(puff.out.find("(0, 0, 0.02) N s on calf at t = 0.7000 s"), std::string::npos);
  EXPECT_EQ(run({"--push", "300@0.5"}).exit_code, 1);
}

TEST_F(HopperPush, IsStatedInTheReportAndActsInEveryTrial) {
  place_.write("still.json", R"({"kind": "randomisation", "version": 1, "name": "still",
    "total_mass_factor": {"least": 0.999, "greatest": 1.001}})");
  const Outcome outcome =
      run({"--push", "300@0.5", "--trials", "3", "--randomise", "still.json", "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_NO_THROW(io::check_document(report, "replay_report", "report", ""));
  EXPECT_EQ(report["options"]["push"], json::array({"300@0.5"}));
  EXPECT_EQ(report["trials"]["succeeded"], 0);
}

TEST_F(HopperPush, WhatIsNoPushIsRefusedByName) {
  const struct {
    const char* push;
    const char* says;
  } refusals[] = {
      {"30", "a push is N_S@TIME"},
      {"1,2@0.3", "a push is N_S@TIME"},
      {"x@0.3", "\"x\" is no number"},
      {"nan@0.3", "\"nan\" is no number"},
      {"1@soon", "\"soon\" is no number"},
      {"tigh:1@0.3", "has no body \"tigh\"; did you mean \"thigh\"?"},
      {"0@0.3", "above 0 N s"},
      {"2e4@0.3", "at most 10000 N s"},
      {"1@-0.1", "the run lasts from 0 to"},
      {"1@99", "the run lasts from 0 to"},
  };
  for (const auto& refusal : refusals) {
    const Outcome outcome = run({"--push", refusal.push});
    EXPECT_EQ(outcome.exit_code, 2) << refusal.push;
    EXPECT_NE(outcome.err.find(refusal.says), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

TEST_F(HopperPush, SidewaysIsRefusedWhereTheBaseKnowsAPlaneAlone) {
  std::string motion =
      "time_s,base_x_position_m,base_z_position_m,base_pitch_position_rad,hip_position_rad,"
      "knee_position_rad\n";
  for (int i = 0; i <= 10; ++i) motion += "0." + std::to_string(10 + i) + ",0,1,0,0.5,-1\n";
  place_.write("leg.csv", motion);
  const Outcome outcome =
      place_.run({"hopper", "replay", in_repository("specs/robot/planar_leg.json"), "leg.csv",
                  "--push", "0,1,0@0.15"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("moves in the plane y = 0 alone"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace torquewright::cli_test
