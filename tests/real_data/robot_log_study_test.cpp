// SPDX-License-Identifier: Apache-2.0
// A quadruped's own log, its legs in the air under their position loops (../shared/data/logs/
// go2_in_air; no part of the repository). Oracle: rollouts of the same robot, law and values in
// MuJoCo 2.2.2, whole and from the first sample, which an examination outside this project made.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

constexpr double kOutside_rad = 14.5e-3;  ///< With the values of the robot's file.
/// Windows that begin anew every 5 s forget what a whole run has gathered: a tenth is allowed for
/// it.
constexpr double kApart_rad = 0.1 * kOutside_rad;

fs::path log_folder() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable)
                                            : fs::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  const fs::path folder = data / "logs" / "go2_in_air";
  return fs::is_directory(folder) ? fs::canonical(folder) : fs::path();
}

json rig() {
  return {
      {"kind", "rig"},
      {"version", 1},
      {"columns",
       {{"time_s", "time_s"},
        {"{leg}_commanded_rad", {{"quantity", "commanded_position_rad"}, {"joint", "{leg}_joint"}}},
        {"{leg}_rad", {{"quantity", "output_position_rad"}, {"joint", "{leg}_joint"}}}}},
      {"load", {{"type", "robot"}, {"file", "go2.json"}, {"base", "held"}}},
      {"controller", {{"type", "pd"}, {"stiffness_Nm_rad", 20}, {"damping_Nm_s_rad", 1.5}}}};
}

TEST(RobotLogStudy, FollowsAQuadrupedAsAnotherEngineDoes) {
  const fs::path folder = log_folder();
  if (folder.empty()) GTEST_SKIP() << "no ../shared/data/logs/go2_in_air: the log is not here";
  const Workplace place;
  ASSERT_EQ(
      place.run({"robot", "import", (folder / "go2.xml").string(), "-o", "go2.json"}).exit_code, 0);
  place.write("rig.json", rig().dump());
  const Outcome outcome =
      place.run({"identify", "residual", (folder / "legs_swinging.csv").string(), "--rig",
                 "rig.json", "--json"});
  ASSERT_FALSE(outcome.out.empty()) << outcome.err;
  const json report = json::parse(outcome.out);
  // The log, the rig and the robot, whose joints make the actuators.
  ASSERT_EQ(report["inputs"].size(), 3u);
  EXPECT_EQ(report["inputs"][2]["path"], "go2.json");
  const json& simulated = report["simulated"];
  const json& longest = simulated["windows"].back()["before"];
  EXPECT_NEAR(longest["train_rms"], kOutside_rad, kApart_rad);
  EXPECT_NEAR(longest["holdout_rms"], kOutside_rad, kApart_rad);
  // One calf is unlike its sisters, in the outside fits too (14.6 mrad, the others 4 to 9).
  std::map<std::string, double> by_joint;
  for (const json& joint : simulated["by_joint"]) {
    by_joint[joint["joint"]] = joint["before"]["holdout_rms"];
  }
  for (const char* sister : {"FL_calf_joint", "FR_calf_joint", "RR_calf_joint"}) {
    EXPECT_GT(by_joint["RL_calf_joint"], 1.5 * by_joint[sister]) << sister;
  }
}

TEST(RobotLogStudy, WritesNothingOverTheRobot) {
  const fs::path folder = log_folder();
  if (folder.empty()) GTEST_SKIP() << "no ../shared/data/logs/go2_in_air: the log is not here";
  const Workplace place;
  const std::string model = (folder / "go2.xml").string();
  ASSERT_EQ(place.run({"robot", "import", model, "-o", "go2.json"}).exit_code, 0);
  place.write("rig.json", rig().dump());
  const std::string before = place.text("go2.json");
  const Outcome outcome = place.run({"identify", (folder / "legs_swinging.csv").string(), "--rig",
                                     "rig.json", "--refined", "FL_calf_joint=go2.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("go2.json: cannot be written: it is an input"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(place.text("go2.json"), before);
}

}  // namespace
}  // namespace torquewright::cli_test
