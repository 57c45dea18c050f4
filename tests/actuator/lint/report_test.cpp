// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "actuator/lint/report_spec.hpp"
#include "io/document.hpp"
#include "io/file_bytes.hpp"
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
  EXPECT_EQ(document["verdict"], "fail");
  EXPECT_EQ(document["findings"].size(), 3u);
  const json& ankle = document["findings"][1];
  EXPECT_EQ(ankle["severity"], "warning");
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
