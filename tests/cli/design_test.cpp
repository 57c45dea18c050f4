// SPDX-License-Identifier: Apache-2.0
// `design`, and what it shares with the candidates of `hopper check`. Oracles: `gearbox optimize`
// of the problem at each ratio, and `hopper check
// --candidates` of the actuators that are written, which go through documents; for what is not
// searched, the same question without leaving anything out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

/// Small teeth, so that there are gears of many ratios; widths and steel say what they bear.
json gears() {
  json problem = json::parse(knee());
  problem["constraints"] = "buildable";
  problem["objective"] = "mass";
  problem["min_teeth"] = {{"sun", 20}, {"planet_1", 18}, {"planet_2", 18}};
  problem["min_carrier_clearance_rad"] = 0;
  problem["planet_count"] = {3, 4};
  problem["face_width_mm"] = {{"layer_1", 30}, {"layer_2", 30}};
  problem["materials"] = {{"density_kg_m3", 7850}, {"steel", "case_hardened"}};
  return problem;
}

/// The hopper's knee motor, one that weighs something, and one that is too weak.
void write_motors(const Workplace& place) {
  std::filesystem::create_directory(place.path("motors"));
  std::filesystem::create_directory(place.path("drives"));
  json motor = json::parse(text_of(in_specs("actuator/d151_knee.json")));
  place.write("motors/unknown.json", motor.dump());
  motor["motor"]["mass_kg"] = 1.3;
  place.write("motors/known.json", motor.dump());
  motor["motor"]["torque_constant_Nm_A"] = 0.02;
  place.write("motors/weak.json", motor.dump());
}

std::vector<std::string> question(const std::vector<std::string>& more) {
  std::vector<std::string> words{"design",
                                 in_specs("robot/hopper.json"),
                                 in_specs("trajectory/hopper_squat.csv"),
                                 "--drive",
                                 "knee",
                                 "--gearbox",
                                 "gears.json",
                                 "--motors",
                                 "motors",
                                 "--ratios",
                                 "12:24:4"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::map<std::string, json> by_name(const json& pairs) {
  std::map<std::string, json> named;
  for (const json& pair : pairs) {
    named[pair["motor"].get<std::string>() + "_" +
          std::to_string(std::lround(pair["ratio"].get<double>()))] = pair;
  }
  return named;
}

TEST(Design, TriesEveryMotorBehindTheProvedGearsOfEveryRatio) {
  const Workplace place;
  write_motors(place);
  place.write("gears.json", gears().dump());
  const Outcome asked = place.run(question({"--write", "drives", "-o", "design.json"}));
  ASSERT_EQ(asked.exit_code, 0) << asked.out << asked.err;
  const json found = json::parse(place.text("design.json"));
  EXPECT_TRUE(io::conforms(found, "drive_design"));
  ASSERT_EQ(found["gearboxes"].size(), 4U);
  int proved = 0;
  for (const json& gearbox : found["gearboxes"]) {
    if (gearbox["search"] == "skipped") continue;
    json problem = gears();
    problem["target_ratio"] = gearbox["ratio"];
    place.write("one.json", problem.dump());
    const json alone = json::parse(place.run({"gearbox", "optimize", "one.json", "--json"}).out);
    if (gearbox["search"] == "none") {
      EXPECT_EQ(alone["status"], "infeasible");
      continue;
    }
    ++proved;
    EXPECT_DOUBLE_EQ(gearbox["choices"][0]["objective"].get<double>(),
                     alone["objective"].get<double>());
    EXPECT_EQ(gearbox["choices"][0]["teeth"], alone["designs"][0]["teeth"]);
  }
  EXPECT_GE(proved, 2);

  const Outcome check =
      place.run({"hopper", "check", in_specs("robot/hopper.json"),
                 in_specs("trajectory/hopper_squat.csv"), "--candidates", "drives", "--json"});
  const json tried = json::parse(check.out);
  const std::map<std::string, json> pairs = by_name(found["pairs"]);
  int compared = 0;
  for (const json& candidate : tried["candidates"]) {
    if (candidate["drives"] != json::array({"knee"})) continue;
    const json& pair = pairs.at(candidate["candidate"]);
    EXPECT_EQ(pair["verdict"], candidate["verdict"]);
    EXPECT_NEAR(pair["margin_share"].get<double>(), candidate["margin_share"].get<double>(), 1e-12);
    EXPECT_NEAR(pair["peak_torque_Nm"].get<double>(), candidate["peak_torque_Nm"].get<double>(),
                1e-9);
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

TEST(Design, RanksByMassAndThoseOfUnknownMassApart) {
  const Workplace place;
  write_motors(place);
  place.write("gears.json", gears().dump());
  const json found = json::parse(place.run(question({"--json"})).out);
  double before_kg = 0.0;
  bool has_unknown = false, has_known = false;
  for (const json& pair : found["pairs"]) {
    if (pair["verdict"] != "pass") break;
    if (pair["mass_kg"].is_null()) {
      EXPECT_EQ(pair["motor"], "unknown");
      has_unknown = true;
      continue;
    }
    EXPECT_FALSE(has_unknown);  // They come after those that are known.
    has_known = true;
    EXPECT_DOUBLE_EQ(pair["mass_kg"].get<double>(), 1.3 + pair["gears_kg"].get<double>());
    EXPECT_GE(pair["mass_kg"].get<double>(), before_kg);
    before_kg = pair["mass_kg"];
  }
  EXPECT_TRUE(has_known);
  EXPECT_TRUE(has_unknown);
}

TEST(Design, LeavesOutNoPairThatWouldDo) {
  const Workplace place;
  write_motors(place);
  place.write("gears.json", gears().dump());
  const json pruned = json::parse(place.run(question({"--json"})).out);
  const json whole = json::parse(place.run(question({"--all-pairs", "--json"})).out);
  EXPECT_GE(pruned["not_searched"].size(), 4U);  // All of the weak motor's.
  EXPECT_TRUE(whole["not_searched"].empty());
  const std::map<std::string, json> all = by_name(whole["pairs"]);
  for (const auto& [name, pair] : by_name(pruned["not_searched"])) {
    if (all.contains(name)) {
      EXPECT_EQ(all.at(name)["verdict"], "fail") << name;
    }
    EXPECT_NE(pair["why"], "");
  }
  for (const auto& [name, pair] : by_name(pruned["pairs"])) EXPECT_EQ(pair, all.at(name));
}

// A rating at the joint was said behind the drive's own gears: behind others it goes with the
// ratio. Oracle: the root mean square of the check itself, beside which 0.8 of it fails and 1.6
// passes.
TEST(HopperCheck, CarriesARatingAtTheJointToOtherGears) {
  const Workplace place;
  const std::string robot = in_specs("robot/hopper.json");
  const std::string motion = in_specs("trajectory/hopper_squat.csv");
  const json own = json::parse(place.run({"hopper", "check", robot, motion, "--json"}).out);
  double rms_Nm = 0.0;
  for (const json& drive : own["joints"]) {
    if (drive["name"] == "knee") rms_Nm = drive["rms_torque_Nm"];
  }
  ASSERT_GT(rms_Nm, 0.0);
  std::filesystem::create_directory(place.path("rated"));
  json rated = json::parse(text_of(in_specs("actuator/d151_knee.json")));
  rated["gearbox"]["ratio"] = 9;
  rated["datasheet"] = {{"side", "joint"}, {"rated_torque_Nm", 0.8 * rms_Nm}};
  place.write("rated/rated.json", rated.dump());
  const json found = json::parse(place
                                     .run({"hopper", "check", robot, motion, "--candidates",
                                           "rated", "--ratios", "9:18:9", "--json"})
                                     .out);
  int seen = 0;
  for (const json& candidate : found["candidates"]) {
    if (candidate["drives"] != json::array({"knee"})) continue;
    ++seen;
    const bool is_own = candidate["ratio"] == 9.0;
    EXPECT_EQ(candidate["verdict"], is_own ? "fail" : "pass");
    const std::string why = candidate["why"];
    EXPECT_EQ(why.find("root mean square") != std::string::npos, is_own) << why;
  }
  EXPECT_EQ(seen, 2);
}

// No motor is known of a drive that is a curve: gears are left out by name, other drives are tried.
TEST(HopperCheck, PutsNoGearsBehindACurve) {
  const Workplace place;
  for (const char* folder : {"robot", "actuator", "gearbox", "shelf"}) {
    std::filesystem::create_directory(place.path(folder));
  }
  place.write("robot/hopper.json", text_of(in_specs("robot/hopper.json")));
  place.write("actuator/d110a_ankle.json", text_of(in_specs("actuator/d110a_ankle.json")));
  for (const char* file : {"d151_strength.json", "d151_knee_result.json", "d151_knee.json"}) {
    place.write(std::string("gearbox/") + file, text_of(in_specs(std::string("gearbox/") + file)));
  }
  ASSERT_EQ(
      place.run({"init", "actuator", "--envelope", "-o", "actuator/d151_knee.json"}).exit_code, 0);
  ASSERT_EQ(place.run({"init", "gearbox", "-o", "shelf/gears.json"}).exit_code, 0);
  place.write("shelf/knee.json", text_of(in_specs("actuator/d151_knee.json")));
  const Outcome outcome =
      place.run({"hopper", "check", "robot/hopper.json", in_specs("trajectory/hopper_squat.csv"),
                 "--candidates", "shelf"});
  EXPECT_LE(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("which is known by a curve"), std::string::npos) << outcome.out;
}

TEST(Design, RefusesWhatItCannotAsk) {
  const Workplace place;
  write_motors(place);
  place.write("gears.json", gears().dump());
  const auto refused = [&](std::vector<std::string> more, const std::string& word) {
    const Outcome outcome = place.run(question(std::move(more)));
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  refused({"--write", "nowhere"}, "is no folder");
  json without = gears();
  without.erase("friction_coefficient");
  place.write("gears.json", without.dump());
  refused({}, "friction_coefficient");
  place.write("gears.json", gears().dump());
  const auto with = [&](const std::string& option, const std::string& value) {
    std::vector<std::string> words = question({});
    *(std::find(words.begin(), words.end(), option) + 1) = value;
    return place.run(words);
  };
  EXPECT_NE(with("--drive", "elbow").err.find("ankle_left"), std::string::npos);
  EXPECT_NE(with("--ratios", "24:12").err.find("24 lies above 12"), std::string::npos);
  EXPECT_NE(with("--ratios", "1:2:x").err.find("\"x\" is not a number"), std::string::npos);
  EXPECT_EQ(with("--ratios", "1:9000:0.01").exit_code, 2);
}

}  // namespace
}  // namespace torquewright::cli_test
