// SPDX-License-Identifier: Apache-2.0
// What `hopper flip` says. Oracle: results filled by hand, and what a reader must not be told: that
// a search that failed proved something, or that what it left is a plan.
#include "src/report/motion/flip_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/report/motion/flip_html.hpp"

namespace torquewright::report {
namespace {

using namespace hopper;

PlannedPhase phase(const char* stance, bool touches, double begin_s, double end_s) {
  PlannedPhase made{stance, std::vector<bool>(2, touches), {}};
  for (int i = 0; i < 5; ++i) {
    made.instants.emplace_back().time_s = begin_s + 0.25 * i * (end_s - begin_s);
  }
  return made;
}

Robot named(const char* name) {
  Robot robot;
  robot.name = name;
  return robot;
}

PlanResult filled(PlanStatus status) {
  PlanResult result;
  result.status = status;
  result.plan.phases = {phase("flat", true, 0.0, 0.4), phase("flight", false, 0.4, 0.9)};
  result.check.emplace();
  result.check->flights = {{0.4, 0.9}};
  result.check->flights[0].rise_m = 0.31;
  result.objectives = {{"effort", 1.0, 1.75, ""}};
  result.angular_momentum_Nm_s = 6.0;
  result.take_off_rad_s = 7.4;
  result.peak_rad_s = 10.6;
  result.least_margins = {{"motor-operating-region", "knee", 0.39, 300.0, 320.0, 20.0, "Nm"}};
  result.binding = {{"knee: region, upper", "flat", 12, 45, 0.25, 0.4, 0.0, "Nm"}};
  result.rounds = {{100, 80, "solved", 3.6, 1e-8, 1.5e-3, 12.5, 2.5}};
  return result;
}

std::string text_of(const PlanResult& result, bool has_seconds = false,
                    const PlanOptions& options = {}) {
  return flip_text({named("leg"), options, result, {"try this"}, "", has_seconds});
}

void expect_line(const std::string& text, const std::string& line) {
  EXPECT_NE(("\n" + text).find("\n" + line + "\n"), std::string::npos) << line << "\nin\n" << text;
}

TEST(FlipText, OfAPlanNamesPhasesFlightMarginsAndWhatBinds) {
  const std::string text = text_of(filled(PlanStatus::kPlanned));
  EXPECT_TRUE(text.starts_with("planned: ")) << text;
  EXPECT_NE(text.find("`hopper check` passes it"), std::string::npos);
  EXPECT_EQ(text.find("proof"), std::string::npos) << text;
  expect_line(text, "  phase    flight  0.4000 to 0.9000 s: 0.5000 s, 2 intervals");
  // 10.6 / 7.4 - 1 = 43.2 %.
  expect_line(text,
              "  flight   0.5000 s; angular momentum 6 Nm s; turns at 7.4 rad/s at take-off, 10.6 "
              "at most (+43.2 %); "
              "0.31 m up");
  expect_line(text,
              "  motor-operating-region   20 Nm of margin: 300 Nm at a limit of 320 Nm, knee, t = "
              "0.3900 s");
  expect_line(text, "  knee: region, upper      12 of 45 instants of flat, t = 0.2500 to 0.4000 s");
  expect_line(text, "next: try this");
}

// A motion of a coarse mesh may run away when it is integrated.
TEST(FlipText, WritesNoInfinity) {
  PlanResult result = filled(PlanStatus::kLocallyInfeasible);
  result.rounds[0].integration_error_rad = HUGE_VAL;
  const std::string text = text_of(result);
  EXPECT_NE(text.find("constraints off by 1.0e-08, integration by more than any number"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("inf "), std::string::npos) << text;
}

TEST(FlipText, StatesSecondsOnlyWhereAsked) {
  const PlanResult result = filled(PlanStatus::kPlanned);
  EXPECT_EQ(text_of(result).find("12.5"), std::string::npos);
  EXPECT_NE(text_of(result, true).find("12.5 s, 2.5 s of it in derivatives"), std::string::npos);
}

TEST(FlipText, OfAPlanThatTheCheckFailsDoesNotSayThatItPasses) {
  PlanResult result = filled(PlanStatus::kPlanned);
  result.check->check.verdict = actuator::Verdict::kFail;
  EXPECT_EQ(text_of(result).find("passes"), std::string::npos);
  result.check.reset();
  EXPECT_EQ(text_of(result).find("passes"), std::string::npos);
}

TEST(FlipText, OfNoPlanSaysThatItIsNoProofAndWhatIsViolated) {
  PlanResult result = filled(PlanStatus::kLocallyInfeasible);
  result.reason = "the knee is too slow";
  result.binding[0].violation = 1.5;
  result.changes = {{"voltage", 48.0, 52.0, "V", true}, {"mass", 12.4, 10.0, "kg", false}};
  const std::string text = text_of(result);
  EXPECT_TRUE(text.starts_with("locally infeasible: the knee is too slow\n")) << text;
  EXPECT_NE(text.find("no proof that there is no plan"), std::string::npos);
  EXPECT_NE(text.find("; violated by 1.5 Nm at most\n"), std::string::npos);
  EXPECT_EQ(text.find("planned: "), std::string::npos);
  expect_line(text, "  voltage 48 -> 52 V: a plan is found");
  expect_line(text, "  mass 12.4 -> 10 kg: still none, tried no further");
}

TEST(FlipText, OfALimitProvesNeither) {
  PlanResult result;
  result.status = PlanStatus::kLimit;
  result.reason = "600 s are over";
  const std::string text = text_of(result);
  EXPECT_TRUE(text.starts_with("limit: 600 s are over\n  neither a plan nor a proof")) << text;
  EXPECT_EQ(text.find("closest"), std::string::npos) << "nothing was found";
  EXPECT_NE(text_of(filled(PlanStatus::kLimit)).find("comes closest"), std::string::npos);
}

TEST(FlipText, ShowsTheFirstOfManyThatBind) {
  PlanResult result = filled(PlanStatus::kPlanned);
  result.binding.assign(15, result.binding.front());
  EXPECT_NE(text_of(result).find("and 3 more (--json lists all)"), std::string::npos);
}

TEST(FlipText, SaysWhatAReserveCosts) {
  PlanResult result = filled(PlanStatus::kPlanned);
  result.prices = {{"voltage", 0.08, "", 1.0, 4.0},
                   {"joint range", 0.15, "rad", 1.875, 2.0, 0.125},
                   {"capture point", 0.0, "", 0.0, {}},
                   {"longest flight", 0.8, "s", 0.0, -0.5}};
  PlanOptions options;
  EXPECT_EQ(text_of(result, false, options).find("reserve"), std::string::npos) << "none is asked";
  options.reserve = 0.08;
  const std::string text = text_of(result, false, options);
  expect_line(text, "what the reserve of 0.08 costs, to first order");
  expect_line(text, "  voltage                  0.08; 0.01 more: objective +0.04");
  expect_line(text,
              "  joint range              0.15 rad, in samples 0.125 rad; 0.01 rad more: objective "
              "+0.02");
  expect_line(text, "  capture point            0; what more of it costs cannot be told");
  expect_line(text, "  longest flight           0.8 s; 0.01 s more: objective -0.005");
  // 4 * 1 + 2 * 1.875.
  expect_line(text, "  together                 0.08; 0.01 more: objective +0.0775");
}

TEST(FlipHtml, WithoutACheckIsAPageOfThePlanAlone) {
  PlanResult result;
  result.status = PlanStatus::kLocallyInfeasible;
  result.reason = "<b>too slow</b>";
  result.binding = {{"knee & <ankle>", "flat", 1, 2, 0.0, 0.1, 0.5, "Nm"}};
  const std::string page = flip_html(named("a<b>"), {}, result);
  EXPECT_NE(page.find("<span class=\"badge fail\">locally infeasible</span>"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;too slow&lt;/b&gt;"), std::string::npos);
  EXPECT_NE(page.find("knee &amp; &lt;ankle&gt;"), std::string::npos);
  EXPECT_NE(page.find("a&lt;b&gt;: a flip?"), std::string::npos);
  EXPECT_NE(page.find("no proof"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

}  // namespace
}  // namespace torquewright::report
