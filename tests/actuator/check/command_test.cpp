// SPDX-License-Identifier: Apache-2.0
// The program as users start it: exit codes, and what stands in the report.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/process.hpp"
#include "io/files/sha256.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright {
namespace {

const std::string kKnee = std::string(TORQUEWRIGHT_SOURCE_DIR) + "/specs/actuator/d151_knee.json";
const std::string kMotion =
    "time_s,knee_position_rad,knee_velocity_rad_s,knee_torque_Nm\n"
    "0,0,5,100\n0.1,0.5,5,200\n0.2,1,5,300\n";

class Command : public testing::Test {
 protected:
  bench::ProcessOutcome run(const std::string& motion, std::vector<std::string> more,
                            const std::string& joint = "knee") {
    const std::string file = folder_.write("m.csv", motion).string();
    std::vector<std::string> arguments{TORQUEWRIGHT_PROGRAM, "actuator", "check", file, "--joint",
                                       joint + "=" + kKnee};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bench::run_process(arguments, 60.0);
  }
  test::ScratchFolder folder_;
};

TEST_F(Command, ExitCodesAreTheVerdicts) {
  EXPECT_EQ(run(kMotion, {"--pause", "1"}).exit_code, 0);
  EXPECT_EQ(run(kMotion, {}).exit_code, 1);  // 34 A rms, of which 20 A may last
  EXPECT_EQ(run(kMotion, {"--pause", "1", "--column", "knee_torque_Nm=knee.torque*1.2"}).exit_code,
            1);
  EXPECT_EQ(run(kMotion,
                {"--pause", "1", "--column", "knee_torque_Nm=other.torque", "--column",
                 "knee_velocity_rad_s=other.velocity"},
                "other")
                .exit_code,
            0);  // the same motion, of another name
  EXPECT_EQ(run("time_s,knee_velocity_rad_s\n0,5\n1,5\n", {}).exit_code, 3);
  EXPECT_EQ(run(kMotion, {}, "kneee").exit_code, 2);
  EXPECT_EQ(run(kMotion, {"--from", "2", "--until", "1"}).exit_code, 2);
  EXPECT_EQ(run(kMotion, {"--plot", "x.pdf"}).exit_code, 2);
  EXPECT_EQ(run(kMotion, {"--torque-includes-inertia", "--torque-excludes-inertia"}).exit_code, 2);
  EXPECT_EQ(run(kMotion, {"--joint", "knee=" + kKnee}).exit_code, 2);
}

TEST_F(Command, JsonHasTheContractsKeys) {
  const bench::ProcessOutcome outcome = run(kMotion, {"--json", "--repeat", "3", "--pause", "1"});
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["kind"], "check_report");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["verdict"], "pass");
  const auto& joint = json["joints"][0];
  for (const char* key :
       {"name", "samples", "clipped_share", "clipped_time_s", "worst", "margin_Nm",
        "peak_torque_Nm", "rms_torque_Nm", "energy_drawn_J", "energy_returned_J"}) {
    EXPECT_TRUE(joint.contains(key)) << key;
  }
  for (const char* key :
       {"time_s", "speed_rad_s", "torque_Nm", "limit_Nm", "excess_Nm", "limiter"}) {
    EXPECT_TRUE(joint["worst"].contains(key)) << key;
  }
  for (const char* key : {"severity", "rule", "time_s", "value", "limit", "unit", "sentence"}) {
    EXPECT_TRUE(json["findings"][0].contains(key)) << key;
  }
  EXPECT_EQ(json["options"]["repeat"], 3);
  EXPECT_EQ(json["inputs"][0]["sha256"], io::sha256(kMotion));
  EXPECT_EQ(run(kMotion, {"--json", "--repeat", "3", "--pause", "1"}).output, outcome.output);
}

}  // namespace
}  // namespace torquewright
