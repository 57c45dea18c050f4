// SPDX-License-Identifier: Apache-2.0
// The page of `hopper replay --report` in a browser. Oracles: the columns of --series and the rows
// of the motion that was replayed; the browser's own layout and network log.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "io/files/csv.hpp"
#include "tests/cli/workplace.hpp"
#include "tests/page/page_fixture.hpp"

namespace torquewright::page_test {
namespace {

using cli_test::in_repository;
using cli_test::text_of;
using cli_test::Workplace;
using nlohmann::json;

const std::string kHostile =
    "</script><script>window.injected = 1</script>\"'><img src=x onerror=window.injected=1>"
    ";//&amp;${window.injected=1}";

/// The flip, which the robot does not survive, of a robot with a name that is code.
class ReplayPage : public WrittenPage {
 protected:
  static void SetUpTestSuite() {
    if (!has_browser()) return;
    json robot = json::parse(text_of(in_repository("specs/robot/hopper.json")));
    robot["name"] = kHostile;
    robot.erase("assumed");
    for (json& mechanism : robot["mechanisms"]) mechanism.erase("transmission_limit");
    const std::filesystem::path actuators = in_repository("specs/actuator");
    robot["mechanisms"][0]["actuators"] = {(actuators / "d151_knee.json").string()};
    robot["mechanisms"][1]["actuators"] = {(actuators / "d110a_ankle.json").string(),
                                           (actuators / "d110a_ankle.json").string()};
    place().write("robot.json", robot.dump());
    write_page({"hopper", "replay", "robot.json",
                in_repository("specs/trajectory/hopper_flip.csv").string(), "--report", "page.html",
                "--series", "series.csv"});
  }

  static void move_to(double time_s) {
    browser().value_of(
        fmt::format("(() => {{ const t = document.getElementById('time'); t.value = {};"
                    "t.dispatchEvent(new Event('input')); }})()",
                    time_s));
  }
  /// Of the numbers that the script reads, at the sample nearest to a time.
  static double number_at(const std::string& column, double time_s) {
    return browser().value_of(
        fmt::format("(() => {{ const c = "
                    "JSON.parse(document.getElementById('motion').textContent).columns;"
                    "const d = c.time_s.map((t) => Math.abs(t - {}));"
                    "return c['{}'][d.indexOf(Math.min(...d))]; }})()",
                    time_s, column));
  }
};

/// A column's value in the row that is nearest to a time.
double nearest(const std::filesystem::path& file, const std::string& header, double time_s) {
  io::CsvReader csv(file);
  const std::size_t time = *csv.find("time_s");
  const std::size_t wanted = *csv.find(header);
  double found = std::nan("");
  double least_s = 1e9;
  while (csv.next()) {
    const double away_s = std::abs(csv.number(time) - time_s);
    if (away_s >= least_s) continue;
    least_s = away_s;
    found = csv.number(wanted);
  }
  return found;
}

TEST_F(ReplayPage, HoldsBothMotions) {
  open(1100);
  for (const double asked_s : {0.2, 0.6, 1.0, 1.3}) {
    const double time_s = number_at("time_s", asked_s);
    for (const char* header :
         {"knee_drive_torque_Nm", "knee_drive_wanted_torque_Nm", "ankle_left_drive_speed_rad_s"}) {
      const double told = nearest(place().path("series.csv"), header, time_s);
      // Five digits are written.
      EXPECT_NEAR(number_at(header, time_s), told, 1e-4 * std::max(1.0, std::abs(told))) << header;
    }
  }
  // The robot has fallen by then; what is planned lands on its feet.
  EXPECT_GT(number_at("planned_height_m", 1.44), number_at("height_m", 1.44) + 0.05);
}

TEST_F(ReplayPage, TheCursorMovesBothSkeletons) {
  open(1100);
  const auto drawn = [](const char* bones) {
    return browser().value_of(
        fmt::format("[...document.querySelectorAll('svg.robot .bone{}')].map((e) => "
                    "['x1', 'y1', 'x2', 'y2'].map((a) => Number(e.getAttribute(a))))",
                    bones));
  };
  move_to(0.0);
  const json is = drawn(":not(.planned)");
  const json should = drawn(".planned");
  ASSERT_GT(is.size(), 3u);
  ASSERT_EQ(is.size(), should.size());
  for (std::size_t i = 0; i < is.size(); ++i) {  // a replay begins where the motion does
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(is[i][k].get<double>(), should[i][k].get<double>(), 0.15);
    }
  }
  move_to(1.4);
  EXPECT_NE(drawn(":not(.planned)"), is);
  EXPECT_NE(drawn(".planned"), should);
  EXPECT_NE(drawn(".planned"), drawn(":not(.planned)"));
}

TEST_F(ReplayPage, SaysHowItEndedAndWhereTorqueWasCutOff) {
  open(1100);
  EXPECT_EQ(browser().value_of("document.querySelector('.badge.fell').textContent"), "fell");
  const std::string reason = browser().value_of("document.querySelector('.reason').textContent");
  EXPECT_NE(reason.find("on the ground"), std::string::npos) << reason;
  const std::string text = browser().value_of("document.querySelector('main').textContent");
  for (const char* words : {"than planned; rotation", "passes the gears", "contacts ask for"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
  EXPECT_GT(browser().value_of("document.querySelectorAll('svg.chart .violated').length"), 0);
  // Every chart has a curve, that of the bus among them: its first row knows no voltage.
  EXPECT_EQ(browser().value_of("[...document.querySelectorAll('svg.chart')].filter((e) => "
                               "!e.querySelector('path[d]') || /NaN|nan|inf/.test(e.outerHTML))"
                               ".length"),
            0);
  move_to(nearest(place().path("series.csv"), "time_s", 0.2));
  EXPECT_EQ(browser().value_of("document.querySelectorAll('svg.robot .bone.bad').length"), 0);
}

TEST_F(ReplayPage, AsksNoNetworkRunsNothingOutOfNamesAndFits) {
  open(390);
  move_to(0.7);
  EXPECT_EQ(browser().requests().size(), 1u);
  EXPECT_TRUE(browser().complaints().empty()) << browser().complaints().front();
  EXPECT_EQ(browser().value_of("typeof window.injected"), "undefined");
  EXPECT_EQ(browser().value_of("document.querySelectorAll('img').length"), 0);
  EXPECT_EQ(browser().value_of("document.querySelectorAll('script').length"), 4);
  EXPECT_LE(browser().value_of("document.documentElement.scrollWidth").get<int>(), 390);
}

// A policy follows no motion: no plan is drawn, told or held against it.
TEST_F(ReplayPage, OfAPolicyShowsNoPlan) {
  const auto outcome =
      place().run({"hopper", "replay", in_repository("specs/robot/hopper.json").string(),
                   in_repository("specs/policy/upright.json").string(), "--report", "policy.html"});
  ASSERT_NE(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(outcome.out.find("  error  "), std::string::npos) << outcome.out;
  browser().open(place().path("policy.html"), 390, 900);
  const std::string text = browser().value_of("document.querySelector('main').textContent");
  EXPECT_NE(text.find("does it do the task?"), std::string::npos);
  EXPECT_EQ(text.find("planned"), std::string::npos);
  EXPECT_EQ(browser().value_of("document.querySelectorAll('svg.robot .bone.planned').length"), 0);
  EXPECT_GT(browser().value_of("document.querySelectorAll('svg.chart path[d]').length"), 0);
  EXPECT_LE(browser().value_of("document.documentElement.scrollWidth").get<int>(), 390);
  EXPECT_TRUE(browser().complaints().empty()) << browser().complaints().front();
}

}  // namespace
}  // namespace torquewright::page_test
