// SPDX-License-Identifier: Apache-2.0
// Oracle: the example that others were promised: keys, units and words as they read them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

json promised() {
  return json::parse(R"({"kind": "replay_report", "version": 1, "verdict": "stands",
    "engine": "own", "limits": "mor", "impact": "invariant",
    "step_s": 0.0001, "control_period_s": 0.0005,
    "touch_down": {"time_s": 1.13, "rotation_short_rad": 0.01},
    "end": {"time_s": 2.7, "foot_at_rest_s": 0.9, "reason": ""},
    "joints": [{"name": "knee", "clipped_share": 0.01, "peak_torque_Nm": 300,
                "peak_tracking_error_rad": 0.05}],
    "transmission_load": [], "contact_load": [], "heat": [], "findings": [],
    "trials": {"count": 200, "succeeded": 190, "interval": [0.91, 0.97]}})");
}

bool conforms(const json& report) { return io::conforms(report, "replay_report"); }

TEST(ReplayReportSchema, TakesWhatWasPromised) {
  json report = promised();
  EXPECT_TRUE(conforms(report));
  report.erase("trials");
  EXPECT_TRUE(conforms(report));
  report["touch_down"] = nullptr;  // without a flight
  for (const char* verdict : {"stands", "missed", "trembles", "fell", "unfinished"}) {
    report["verdict"] = verdict;
    EXPECT_TRUE(conforms(report)) << verdict;
  }
}

TEST(ReplayReportSchema, TakesFindingsOfJoints) {
  json report = promised();
  for (const char* rule : {"joint-speed", "joint-torque"}) {
    report["findings"] = {{{"severity", "violation"},
                           {"rule", rule},
                           {"joint", "knee"},
                           {"time_s", 0.9},
                           {"value", -31.3},
                           {"limit", 20.0},
                           {"unit", "Nm"},
                           {"sentence", "knee: torque of -31.3 Nm"}}};
    EXPECT_TRUE(conforms(report)) << rule;
  }
}

TEST(ReplayReportSchema, MissesEachKey) {
  const json whole = promised();
  for (const auto& entry : whole.items()) {
    json report = whole;
    report.erase(entry.key());
    EXPECT_EQ(conforms(report), entry.key() == "trials") << entry.key();
  }
}

TEST(ReplayReportSchema, RefusesWhatIsNoReport) {
  const auto with = [](const char* pointer, json value) {
    json report = promised();
    report[json::json_pointer(pointer)] = std::move(value);
    return report;
  };
  EXPECT_FALSE(conforms(with("/verdict", "pass")));
  EXPECT_FALSE(conforms(with("/engine", "bullet")));
  EXPECT_FALSE(conforms(with("/limits", "torque")));
  EXPECT_FALSE(conforms(with("/stands", true)));
  EXPECT_FALSE(conforms(with("/joints/0/clipped_share", 1.5)));
  EXPECT_FALSE(conforms(with("/trials/interval", {0.9, 1.1})));
  EXPECT_FALSE(conforms(with("/trials/interval", {0.9})));
  EXPECT_FALSE(conforms(with("/end/reason", nullptr)));
}

}  // namespace
}  // namespace torquewright::hopper
