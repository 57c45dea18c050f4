// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "actuator/lint/report_spec.hpp"
#include "io/documents/document.hpp"
#include "io/files/file_bytes.hpp"
#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

using nlohmann::json;

Report both() {
  return examine_all(std::vector{from_specs("d151_knee.json"), from_specs("d110a_ankle.json")});
}

TEST(LintReport, IsOfItsSchema) {
  const json document = json::parse(report_json(both()).dump());
  EXPECT_NO_THROW(io::check_document(document, "lint_report", "report", ""));
  EXPECT_EQ(document["verdict"], "pass");
  EXPECT_EQ(document["findings"].size(), 3u);
  const json& ankle = document["findings"][1];
  EXPECT_EQ(ankle["severity"], "note");
  EXPECT_EQ(ankle["rule"], "no-load-speed");
  EXPECT_EQ(ankle["value"], 20);
  EXPECT_EQ(ankle["unit"], "rad/s");
  EXPECT_EQ(ankle["stated"]["pointers"], json({"/datasheet/no_load_speed_rad_s"}));
  EXPECT_EQ(ankle["assumed"], json({"/motor/torque_constant_convention"}));
}

// A field that can be weakened to nothing has no greatest speed: null, not a number that is none.
TEST(LintReport, SaysNullForUnlimited) {
  Actuator document = sample();
  document.motor.inductance_d_H = 0.000125;
  document.drive.field_weakening = true;
  document.drive.peak_current_A = 60;
  document.datasheet->no_load_speed_rad_s = 12;
  const json report = json::parse(report_json(examine_all(std::vector{document})).dump());
  EXPECT_NO_THROW(io::check_document(report, "lint_report", "report", ""));
  EXPECT_TRUE(report["actuators"][0]["comparisons"][0]["expected"]["high"].is_null());
  EXPECT_EQ(report["verdict"], "fail");
}

// Oracle: the figures put into it, each another.
TEST(LintReport, HoldsEveryFigureUnderItsKey) {
  Report report;
  report.examinations.push_back({"knee",
                                 {{"rule",
                                   "V",
                                   "a b",
                                   Demand::kAtMost,
                                   {5, 4.5, 5.5, {"/s"}},
                                   {2, 1.5, 2.5, {"/e", "/f"}},
                                   false}},
                                 {}});
  Finding finding;
  finding.severity = Severity::kViolation;
  finding.rule = "rule";
  finding.actuator = "knee";
  finding.unit = "V";
  finding.sentence = "It is so.";
  finding.stated = {5, 4.5, 5.5, {"/s"}};
  finding.expected = {2, 1.5, 2.5, {"/e"}};
  finding.assumed = {"/e"};
  finding.explanations = {{"one", RoundedInterval{7, 6.5, 7.5, {}}, Agreement::kFits},
                          {"two", std::nullopt, Agreement::kAdmits},
                          {"three", std::nullopt, Agreement::kExcludes}};
  finding.explained_by = {"four", "five"};
  finding.culprits = {{"/c", "/d"}};
  report.findings.push_back(finding);
  CommonFactor& common = report.common_factor.emplace();
  common.required = {{"knee", {1, 0.5, 1.5, {}}, {20, 19.5, 20.5, {}}, 40}};
  common.low = 0.75;
  common.high = 1.25;
  common.candidates = {
      {CurrentConvention::kDc, "dc", 1.5, {exact(10), exact(12)}, Agreement::kAdmits}};
  EXPECT_EQ(json::parse(report_json(report).dump()), json::parse(R"({
    "kind": "lint_report", "version": 1, "verdict": "fail",
    "actuators": [{"name": "knee", "comparisons": [{"rule": "rule", "unit": "V", "equation": "a b",
      "demand": "at_most", "agrees": false,
      "stated": {"value": 5.0, "low": 4.5, "high": 5.5, "pointers": ["/s"]},
      "expected": {"value": 2.0, "low": 1.5, "high": 2.5, "pointers": ["/e", "/f"]}}]}],
    "findings": [{"severity": "violation", "rule": "rule", "actuator": "knee", "value": 5.0,
      "limit": 2.5, "unit": "V", "sentence": "It is so.",
      "stated": {"value": 5.0, "low": 4.5, "high": 5.5, "pointers": ["/s"]},
      "expected": {"value": 2.0, "low": 1.5, "high": 2.5, "pointers": ["/e"]}, "assumed": ["/e"],
      "explanations": [
        {"sentence": "one", "fit": "fits",
         "expected": {"value": 7.0, "low": 6.5, "high": 7.5, "pointers": []}},
        {"sentence": "two", "fit": "admits", "expected": null},
        {"sentence": "three", "fit": "excludes", "expected": null}],
      "explained_by": ["four", "five"], "culprits": [["/c", "/d"]]}],
    "common_factor": {
      "actuators": [{"name": "knee",
        "factor": {"value": 1.0, "low": 0.5, "high": 1.5, "pointers": []},
        "speed_rad_s": {"value": 20.0, "low": 19.5, "high": 20.5, "pointers": []}}],
      "overlap": {"low": 0.75, "high": 1.25},
      "candidates": [{"sentence": "dc", "factor": 1.5, "fit": "admits",
        "speeds_rad_s": [10.0, 12.0]}]}})"));
  common.low = common.high = 1.0;  // they touch
  EXPECT_FALSE(report_json(report)["common_factor"]["overlap"].is_null());
  common.low = 1.5;
  EXPECT_TRUE(report_json(report)["common_factor"]["overlap"].is_null());
}

// By hand: 24 V over 0.245...0.255 ohm are 94.118...97.959 A. 99.5 is 1.57 % above the most, 90.5
// is 3.84 % below the least; the interval's nearer end is the limit.
TEST(Findings, SayByHowMuchAtLeast) {
  Actuator document = sample();
  document.datasheet->stall_current_A = 100;
  const Finding above = finding(document, "stall-current").value();
  EXPECT_NE(
      above.sentence.find("/datasheet/stall_current_A says 100 (99.5 to 100.5) A; by V / R it "
                          "follows as 96 (94.12 to 97.96) A, too much by 1.6 %, rounding "
                          "allowed for"),
      std::string::npos)
      << above.sentence;
  EXPECT_EQ(above.actuator, "sample");
  EXPECT_EQ(above.unit, "A");
  EXPECT_NEAR(limit(above), 24 / 0.245, 1e-12 * 100);
  document.datasheet->stall_current_A = 90;
  const Finding below = finding(document, "stall-current").value();
  EXPECT_NE(below.sentence.find(", too little by 3.8 %, rounding allowed for"), std::string::npos)
      << below.sentence;
  EXPECT_NEAR(limit(below), 24 / 0.255, 1e-12 * 100);
}

// What a number rests on is assumed where its pointer is, or a part of it, or the whole around it.
TEST(Findings, NameWhatIsAssumedOfTheirNumbers) {
  Actuator document = sample();
  document.datasheet->stall_current_A = 100;
  document.assumed = {"/motor/resistance_ohm", "/drive", "/motor/resist", "/mass_kg",
                      "/datasheet/stall_current_A/0"};
  EXPECT_EQ(finding(document, "stall-current").value().assumed,
            (std::vector<std::string>{"/motor/resistance_ohm", "/drive",
                                      "/datasheet/stall_current_A/0"}));
}

TEST(LintReport, PassesWithNotesAlone) {
  const Report knee = examine_all(std::vector{from_specs("d151_knee.json")});
  EXPECT_EQ(knee.findings.size(), 1u);
  EXPECT_FALSE(has_contradiction(knee));
  EXPECT_EQ(report_json(knee)["verdict"], "pass");
}

TEST(LintReport, HasEveryRuleInItsPage) {
  const std::string page =
      io::read_file_bytes(std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "docs/lint.md");
  for (const Check* check : library()) {
    EXPECT_NE(page.find("| `" + std::string(check->rule) + "` |"), std::string::npos)
        << check->rule;
  }
}

}  // namespace
}  // namespace torquewright::actuator::lint
