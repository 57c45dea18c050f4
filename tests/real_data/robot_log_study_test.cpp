// SPDX-License-Identifier: Apache-2.0
// A quadruped's own log, its legs in the air under their position loops (../shared/data/logs/
// go2_in_air; no part of the repository). Oracle: rollouts of the same robot, law and values in
// MuJoCo 2.2.2, whole and from the first sample, which an examination outside this project made.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

constexpr double kOutside_rad = 14.5e-3;  ///< With the values of the robot's file.
/// The measured state that a run begins with, and the last third that begins anew: a tenth is
/// allowed for it.
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

/// A part of a log takes a part of the time.
std::string first_lines(const fs::path& file, int lines) {
  std::ifstream stream(file);
  std::string text;
  std::string line;
  for (int i = 0; i < lines && std::getline(stream, line); ++i) text += line + "\n";
  return text;
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
  EXPECT_NEAR(simulated["before"]["train_rms"], kOutside_rad, kApart_rad);
  EXPECT_NEAR(simulated["before"]["holdout_rms"], kOutside_rad, kApart_rad);
  // One calf is unlike its sisters, in the outside fits too (14.6 mrad, the others 4 to 9).
  std::map<std::string, double> by_joint;
  for (const json& joint : simulated["by_joint"]) {
    by_joint[joint["joint"]] = joint["before"];
  }
  for (const char* sister : {"FL_calf_joint", "FR_calf_joint", "RR_calf_joint"}) {
    EXPECT_GT(by_joint["RL_calf_joint"], 1.5 * by_joint[sister]) << sister;
  }
}

// Oracle: the same log, all of it, in the hands of others. PACE's 49 numbers leave 7.5 mrad on the
// third that was not fitted, with load friction, torque factors and the direction of gravity 6.6
// are left (MuJoCo, outside this project); 6.5 is the goal. In all of those fits one calf is unlike
// its sisters, and none says why.
TEST(RobotLogStudy, FollowsTheLegsCloserThanListsOfNumbersAndNamesTheCalf) {
  const fs::path folder = log_folder();
  if (folder.empty()) GTEST_SKIP() << "no ../shared/data/logs/go2_in_air: the log is not here";
  const Workplace place;
  const std::string model = (folder / "go2.xml").string();
  ASSERT_EQ(place.run({"robot", "import", model, "-o", "go2.json"}).exit_code, 0);
  json alike_rig = rig();
  alike_rig["alike"] = {{"*_hip_joint"}, {"*_thigh_joint"}, {"*_calf_joint"}};
  place.write("rig.json", alike_rig.dump());
  place.write("legs.csv", first_lines(folder / "legs_swinging.csv", 1800));
  const Outcome outcome =
      place.run({"identify", "legs.csv", "--rig", "rig.json", "--only", "viscous_friction",
                 "--json", "--refined", "RL_calf_joint=calf.json"});
  ASSERT_FALSE(outcome.out.empty()) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(report["simulated"]["after_is_fitted"]);
  EXPECT_LT(report["simulated"]["after"]["holdout_rms"], 6.5e-3);
  EXPECT_EQ(report["joints"].size(), 12u);
  bool is_named = false;
  for (const json& number : report["alike"]) {
    const std::string name = number["name"];
    for (const json& unlike : number["unlike"]) {
      is_named =
          is_named || (unlike["joint"] == "RL_calf_joint" && name.starts_with("dry_friction_Nm"));
    }
  }
  EXPECT_TRUE(is_named) << report["alike"].dump(1);
  // No offset beyond what a calibration leaves is told as certain.
  for (const json& value : report["simulated"]["values"]) {
    if (value["name"] != "encoder_offset_rad") continue;
    EXPECT_TRUE(!value["told"] || std::abs(value["value"].get<double>()) < 0.05) << value.dump();
  }
  const json calf = json::parse(place.text("calf.json"));
  bool has_wave = false;
  for (const json& effect : calf["effects"]) {
    has_wave = has_wave || effect["effect"] == "position_dependent_friction";
  }
  EXPECT_TRUE(has_wave) << calf.dump(1);
}

TEST(RobotLogStudy, SaysWhoseLawIsMissingWhereNothingIsSimulated) {
  const fs::path folder = log_folder();
  if (folder.empty()) GTEST_SKIP() << "no ../shared/data/logs/go2_in_air: the log is not here";
  const Workplace place;
  const std::string model = (folder / "go2.xml").string();
  ASSERT_EQ(place.run({"robot", "import", model, "-o", "go2.json"}).exit_code, 0);
  json part = rig();
  part["controllers"] = {{"*_hip_joint", part["controller"]},
                         {"*_thigh_joint", part["controller"]}};
  part.erase("controller");
  place.write("rig.json", part.dump());
  place.write("legs.csv", first_lines(folder / "legs_swinging.csv", 800));
  const Outcome outcome = place.run({"identify", "residual", "legs.csv", "--rig", "rig.json"});
  EXPECT_NE(outcome.out.find("the law of FL_calf_joint, FR_calf_joint, RL_calf_joint, RR_calf_joint"
                             " is not stated"),
            std::string::npos)
      << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.find("simulated      the whole robot"), std::string::npos);
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
