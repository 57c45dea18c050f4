// SPDX-License-Identifier: Apache-2.0
// The report as JSON. Oracle: the figures put into it, each another, and what docs/checks.md calls
// them.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "actuator/drive_check/check_report_spec.hpp"

namespace torquewright::actuator {
namespace {

CheckedInterpretation interpretation() {
  CheckedInterpretation result;
  result.clipped_samples = 3;
  result.clipped_time_s = 0.5;
  result.worst = {1.5, -2.5, 31.0, 30.0, 1.0, Limiter::kGear};
  result.margin_Nm = -1.0;
  result.speed_margin_rad_s = 4.5;
  result.voltage_margin_V = 5.5;
  result.peak_torque_Nm = 33.0;
  result.rms_torque_Nm = 12.0;
  result.peak_current_A = 34.0;
  result.rms_current_A = 13.0;
  result.energy_drawn_J = 100.0;
  result.energy_returned_J = 7.0;
  return result;
}

DriveReport drive() {
  DriveReport result;
  result.name = "k";
  result.actuator = "simple";
  result.verdict = Verdict::kFail;
  result.samples = 12;
  result.from_s = 0.25;
  result.until_s = 6.0;
  result.peak_speed_rad_s = 8.0;
  result.no_load_speed_rad_s = 48.0;
  result.armature_kg_m2 = 0.01;
  result.interpretation = interpretation();
  result.left_out = {"backlash"};
  result.assumed = {"/motor"};
  return result;
}

nlohmann::json joint_of(const DriveReport& drive) {
  CheckReport report;
  report.drives = {drive};
  return nlohmann::json::parse(check_report_json(report).dump())["joints"][0];
}

TEST(CheckReport, HoldsEveryFigureUnderItsKey) {
  EXPECT_EQ(joint_of(drive()), nlohmann::json::parse(R"({
    "name": "k", "actuator": "simple", "verdict": "fail", "samples": 12, "from_s": 0.25,
    "until_s": 6.0, "clipped_samples": 3, "clipped_share": 0.25, "clipped_time_s": 0.5,
    "worst": {"time_s": 1.5, "speed_rad_s": -2.5, "torque_Nm": 31.0, "limit_Nm": 30.0,
      "excess_Nm": 1.0, "limiter": "gear"},
    "margin_Nm": -1.0, "speed_margin_rad_s": 4.5, "voltage_margin_V": 5.5, "peak_torque_Nm": 33.0,
    "rms_torque_Nm": 12.0, "peak_current_A": 34.0, "rms_current_A": 13.0,
    "continuous": {"rms_current_A": 0.0, "limit_A": null, "margin_A": null},
    "energy_drawn_J": 100.0,
    "energy_returned_J": 7.0, "winding": null, "peak_speed_rad_s": 8.0,
    "no_load_speed_rad_s": 48.0, "armature_kg_m2": 0.01, "torque_includes_inertia": null,
    "velocity_differentiated": false, "left_out": ["backlash"], "assumed": ["/motor"]})"));
}

TEST(CheckReport, SharesOfASingleSampleAreWhole) {
  DriveReport single = drive();
  single.samples = 1;
  single.interpretation.clipped_samples = 1;
  EXPECT_EQ(joint_of(single)["clipped_share"], 1.0);
}

// What JSON has no number for is null, and a negative zero is a zero.
TEST(CheckReport, SaysNullForWhatIsUnlimited) {
  DriveReport odd = drive();
  odd.no_load_speed_rad_s = std::numeric_limits<double>::infinity();
  odd.interpretation.speed_margin_rad_s.reset();
  odd.interpretation.worst.limit_Nm.reset();
  odd.interpretation.margin_Nm = -0.0;
  const nlohmann::json joint = joint_of(odd);
  EXPECT_TRUE(joint["no_load_speed_rad_s"].is_null());
  EXPECT_TRUE(joint["speed_margin_rad_s"].is_null());
  EXPECT_TRUE(joint["worst"]["limit_Nm"].is_null());
  EXPECT_EQ(joint["margin_Nm"].dump(), "0.0");
}

TEST(CheckReport, WithoutTorqueTellsOnlyOfSpeeds) {
  DriveReport still = drive();
  still.has_torque = false;
  EXPECT_TRUE(joint_of(still)["clipped_samples"].is_null());
  EXPECT_TRUE(joint_of(still)["clipped_share"].is_null());
  still.impossible_speeds = 6;
  const nlohmann::json joint = joint_of(still);
  EXPECT_EQ(joint["clipped_samples"], 6);
  EXPECT_EQ(joint["clipped_share"], 0.5);
  for (const char* key :
       {"clipped_time_s", "worst", "margin_Nm", "speed_margin_rad_s", "voltage_margin_V",
        "peak_torque_Nm", "rms_torque_Nm", "peak_current_A", "rms_current_A", "continuous",
        "energy_drawn_J", "energy_returned_J", "winding"}) {
    ASSERT_TRUE(joint.contains(key)) << key;
    EXPECT_TRUE(joint[key].is_null()) << key;
  }
}

TEST(CheckReport, SaysWhoseTorqueItIs) {
  DriveReport told = drive();
  told.inertia = InertiaConvention::kIncluded;
  EXPECT_EQ(joint_of(told)["torque_includes_inertia"], true);
  told.inertia = InertiaConvention::kExcluded;
  EXPECT_EQ(joint_of(told)["torque_includes_inertia"], false);
  told.inertia = InertiaConvention::kUnstated;
  told.with_inertia = interpretation();
  told.with_inertia->clipped_samples = 0;
  const nlohmann::json readings = joint_of(told)["readings"];
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0]["torque_includes_inertia"], true);
  EXPECT_EQ(readings[0]["verdict"], "fail");
  EXPECT_EQ(readings[0]["clipped_share"], 0.25);
  EXPECT_EQ(readings[1]["torque_includes_inertia"], false);
  EXPECT_EQ(readings[1]["verdict"], "pass");
  EXPECT_EQ(readings[1]["clipped_share"], 0.0);
}

TEST(CheckReport, HoldsWhatMayLast) {
  DriveReport rated = drive();
  rated.interpretation.continuous_current = {13.0, 10.0, 0.7};
  rated.interpretation.continuous_torque = {1.5, 2.0, 0.0};
  rated.interpretation.is_rated_at_joint = false;
  EXPECT_EQ(joint_of(rated)["continuous"], nlohmann::json::parse(R"({"rms_current_A": 13.0,
    "limit_A": 10.0, "margin_A": -3.0, "side": "motor", "rms_torque_Nm": 1.5, "limit_Nm": 2.0,
    "margin_Nm": 0.5})"));
}

TEST(CheckReport, HoldsTheWindingsHeat) {
  DriveReport hot = drive();
  WindingReport& winding = hot.interpretation.winding.emplace();
  winding.limit_K = 400.0;
  winding.runs = 5;
  winding.first_peak_K = 310.0;
  winding.peak_K = 330.0;
  winding.end_K = 320.0;
  winding.steady_peak_K = 390.0;
  winding.runs_to_steady = 70;
  winding.resolution_s = 0.016;
  EXPECT_EQ(joint_of(hot)["winding"], nlohmann::json::parse(R"({"limit_K": 400.0, "runs": 5,
    "first_run_peak_K": 310.0, "peak_K": 330.0, "end_K": 320.0, "steady_peak_K": 390.0,
    "runs_to_steady": 70, "runs_to_limit": null, "resolution_s": 0.016})"));
}

TEST(CheckReport, HoldsItsFindings) {
  CheckReport report;
  report.verdict = Verdict::kUndecided;
  report.findings = {
      {Severity::kViolation, "rule", "k", 1.0, 2.0, 3.0, "Nm", "It is so."},
      {Severity::kNote, "other", "", {}, {}, {}, "", "Of no joint."},
  };
  EXPECT_EQ(nlohmann::json::parse(check_report_json(report).dump()), nlohmann::json::parse(R"({
    "kind": "check_report", "version": 1, "verdict": "undecided", "joints": [], "findings": [
      {"severity": "violation", "rule": "rule", "joint": "k", "time_s": 1.0, "value": 2.0,
       "limit": 3.0, "unit": "Nm", "sentence": "It is so."},
      {"severity": "note", "rule": "other", "joint": null, "time_s": null, "value": null,
       "limit": null, "unit": "", "sentence": "Of no joint."}]})"));
}

}  // namespace
}  // namespace torquewright::actuator
