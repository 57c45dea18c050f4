// SPDX-License-Identifier: Apache-2.0
// A plan as a document. Oracles: the schema, and the numbers that were put in by hand.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "hopper/planning/search/plan_report_spec.hpp"
#include "io/documents/schema.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

PlannedPhase phase(const char* stance, bool touches, double begin_s, double end_s) {
  PlannedPhase made{stance, std::vector<bool>(2, touches), {}};
  for (int i = 0; i < 5; ++i) {
    made.instants.emplace_back().time_s = begin_s + 0.25 * i * (end_s - begin_s);
  }
  return made;
}

/// As of a flip that lands on its heel.
PlanResult filled() {
  PlanResult result;
  result.status = PlanStatus::kPlanned;
  result.plan.phases = {phase("flat", true, 0.0, 0.5), phase("flight", false, 0.5, 1.0),
                        phase("heel", true, 1.0, 1.125)};
  result.check.emplace();
  result.check->flights = {{0.5, 0.52}, {0.52, 1.0}};
  result.check->flights[1].rise_m = 0.25;
  result.objective = 3.5;
  result.objectives = {{"effort", 2.0, 1.75, ""}};
  result.iterations = 120;
  result.largest_violation = 1e-9;
  result.integration_error_rad = 1.5e-3;
  result.angular_momentum_Nm_s = 6.0;
  result.take_off_rad_s = 7.5;
  result.peak_rad_s = 10.5;
  result.least_margins = {{"friction-cone", "heel_left", 0.25, 0.5, kInfinite, 0.125, ""}};
  result.binding = {{"knee: region, upper", "flat", 12, 45, 0.25, 0.5, 0.0, "Nm"}};
  result.rounds = {{100, 80, "solved", 3.6, 1e-8, 4e-3, 12.5, 2.5},
                   {130, 40, "solved", 3.5, 1e-9, 1.5e-3, 9.0, 2.0}};
  result.changes = {{"voltage", 48.0, 52.0, "V", true}};
  result.prices = {{"joint range", 0.15, "rad", 1.875, 2.0, 0.125},
                   {"longest flight", 0.8, "s", 0.0, {}}};
  return result;
}

json report_of(const PlanResult& result, PlanSeconds seconds = PlanSeconds::kLeftOut,
               const PlanOptions& options = {}) {
  return json::parse(plan_report_json(options, result, seconds).dump());
}

bool conforms(const json& report) { return io::conforms(report, "plan_report"); }

TEST(PlanReport, HoldsWhatThePlanHolds) {
  const json report = report_of(filled());
  EXPECT_TRUE(conforms(report)) << report.dump(1);
  EXPECT_EQ(report["status"], "planned");
  EXPECT_EQ(report["task"], "flip");
  EXPECT_EQ(report["limits"], "mor");
  ASSERT_EQ(report["phases"].size(), 3u);
  EXPECT_EQ(report["phases"][2],
            json({{"stance", "heel"}, {"begin_s", 1.0}, {"end_s", 1.125}, {"intervals", 2}}));
  EXPECT_EQ(report["cam_kg_m2_s"], 6.0);
  EXPECT_EQ(report["cav_take_off_rad_s"], 7.5);
  EXPECT_EQ(report["cav_peak_rad_s"], 10.5);
  EXPECT_EQ(report["flight"], json({{"from_s", 0.5}, {"until_s", 1.0}, {"rise_m", 0.25}}));
  EXPECT_EQ(report["objectives"][0],
            json({{"name", "effort"}, {"weight", 2.0}, {"value", 1.75}, {"unit", ""}}));
  EXPECT_EQ(report["least_margins"][0]["margin"], 0.125);
  EXPECT_EQ(report["least_margins"][0]["limit"], nullptr) << "infinity is no number of JSON";
  EXPECT_EQ(report["binding"][0]["instants"], 12);
  EXPECT_EQ(report["binding"][0]["of"], 45);
  EXPECT_EQ(report["prices"][0], json({{"name", "joint range"},
                                       {"value", 0.15},
                                       {"unit", "rad"},
                                       {"per_reserve", 1.875},
                                       {"objective_per_unit", 2.0},
                                       {"kept", 0.125}}));
  EXPECT_EQ(report["prices"][1]["objective_per_unit"], nullptr);
  EXPECT_EQ(report["reserve"], nullptr);
  PlanOptions options;
  options.reserve = 0.08;
  const json reserved = report_of(filled(), PlanSeconds::kLeftOut, options);
  EXPECT_TRUE(conforms(reserved));
  EXPECT_EQ(reserved["reserve"], json({{"value", 0.08}, {"objective_per_unit", 3.75}}));
  EXPECT_EQ(report["check"]["verdict"], "pass");
  EXPECT_TRUE(io::conforms(report["check"], "check_report")) << report["check"].dump(1);
  EXPECT_EQ(report["iterations"], 120);
  EXPECT_EQ(report["integration_error_rad"], 1.5e-3);
  ASSERT_EQ(report["rounds"].size(), 2u);
  EXPECT_EQ(report["rounds"][1]["intervals"], 130);
  EXPECT_EQ(report["changes"][0], json({{"quantity", "voltage"},
                                        {"from", 48.0},
                                        {"to", 52.0},
                                        {"unit", "V"},
                                        {"has_plan", true},
                                        {"cut_off", false}}));
}

TEST(PlanReport, StatesSecondsOnlyWhereAsked) {
  PlanResult slower = filled();
  for (PlanRound& round : slower.rounds) round.seconds *= 2.0;
  EXPECT_EQ(report_of(filled()), report_of(slower));
  const json timed = report_of(filled(), PlanSeconds::kStated);
  EXPECT_TRUE(conforms(timed));
  EXPECT_EQ(timed["rounds"][0]["seconds"], 12.5);
  EXPECT_EQ(timed["rounds"][0]["derivative_seconds"], 2.5);
}

TEST(PlanReport, OfNothingFoundHasNulls) {
  PlanResult nothing;
  nothing.status = PlanStatus::kLocallyInfeasible;
  nothing.reason = "none";
  nothing.objective = std::numeric_limits<double>::quiet_NaN();
  PlanOptions options;
  options.task = &tasks::hop;
  options.limits = DriveLimits::kBox;
  const json report = report_of(nothing, PlanSeconds::kLeftOut, options);
  EXPECT_TRUE(conforms(report)) << report.dump(1);
  EXPECT_EQ(report["status"], "locally_infeasible");
  EXPECT_EQ(report["task"], "hop");
  EXPECT_EQ(report["limits"], "box");
  EXPECT_EQ(report["reason"], "none");
  for (const char* key :
       {"flight", "cam_kg_m2_s", "cav_take_off_rad_s", "cav_peak_rad_s", "check"}) {
    EXPECT_EQ(report[key], nullptr) << key;
  }
  EXPECT_EQ(report["objective"], nullptr);
}

// The example that others were promised: keys, units and words as they read them.
TEST(PlanReport, TakesWhatWasPromised) {
  json promised = json::parse(R"({"kind": "plan_report", "version": 1, "status": "planned",
    "task": "flip", "limits": "mor", "objective": 0.1, "iterations": 200,
    "largest_violation": 1e-8, "integration_error_rad": 0.001,
    "cam_kg_m2_s": 6.0, "cav_take_off_rad_s": 7.4, "cav_peak_rad_s": 10.6,
    "check": {}, "least_margins": [], "binding": []})");
  promised["check"] = report_of(filled())["check"];
  EXPECT_TRUE(conforms(promised));
  const json written = report_of(filled());
  for (const auto& entry : promised.items()) {
    EXPECT_TRUE(written.contains(entry.key())) << entry.key();
    json report = promised;
    report.erase(entry.key());
    EXPECT_FALSE(conforms(report)) << entry.key();
  }
}

TEST(PlanReport, RefusesWhatIsNoReport) {
  const auto with = [](const char* pointer, json value) {
    json report = report_of(filled());
    report[json::json_pointer(pointer)] = std::move(value);
    return report;
  };
  EXPECT_FALSE(conforms(with("/status", "infeasible")));
  EXPECT_FALSE(conforms(with("/task", "walk")));
  EXPECT_FALSE(conforms(with("/limits", "torque")));
  EXPECT_FALSE(conforms(with("/seconds", 12.0)));
  EXPECT_FALSE(conforms(with("/rounds/0/intervals", -1)));
  EXPECT_FALSE(conforms(with("/changes/0/has_plan", "yes")));
  EXPECT_FALSE(conforms(with("/check/verdict", "planned")));
}

}  // namespace
}  // namespace torquewright::hopper
