// SPDX-License-Identifier: Apache-2.0
// The page of `hopper check --report` in a browser, as who gets it sees it. Oracles: the columns of
// --series, which the marks must stand at; the browser's own layout, network log and accessibility
// tree.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>

#include "io/files/csv.hpp"
#include "tests/cli/workplace.hpp"
#include "tests/page/page_fixture.hpp"

namespace torquewright::page_test {
namespace {

using cli_test::in_repository;
using cli_test::text_of;
using cli_test::Workplace;
using nlohmann::json;

constexpr int kWide = 1100;
constexpr int kNarrow = 390;

/// Every attribute that the cursor may move: of the figure, and of the marks in the charts.
constexpr const char* kDrawn =
    "[...document.querySelectorAll('svg.robot [class], .moves')].filter((e) => "
    "!['ground', 'way'].includes(e.getAttribute('class'))).map((e) => "
    "[e.getAttribute('x1'), e.getAttribute('y1'), e.getAttribute('cx'), e.getAttribute('cy'), "
    "e.getAttribute('d'), e.getAttribute('class')].join(' '))";
constexpr const char* kTime = "Number(document.getElementById('time').value)";

class HopperPage : public WrittenPage {
 protected:
  static void SetUpTestSuite() {
    if (!has_browser()) return;
    write_page({"hopper", "check", in_repository("specs/robot/hopper.json").string(),
                in_repository("specs/trajectory/hopper_flip.csv").string(), "--candidates",
                in_repository("specs/actuator").string(), "--report", "page.html", "--series",
                "series.csv"});
  }
};

/// Every mark at the cursor's time: those out of sight follow when the cursor rests.
constexpr const char* kAllStand =
    "(() => { const t = Number(document.getElementById('clock').textContent.split(' ')[0]);"
    "return [...document.querySelectorAll('circle.now.there[data-x=\"time_s\"]')].every((d) => {"
    "const c = d.ownerSVGElement.dataset;"
    "return Math.abs((d.getAttribute('cx') - c.xZero) / c.xSlope - t) < 6e-4; }); })()";

/// A click on the slider, at that share of its length.
void click_slider(Browser& browser, double share) {
  const json box = browser.value_of(
      "(() => { const b = document.getElementById('time').getBoundingClientRect();"
      "return [b.left, b.width, b.top + b.height / 2]; })()");
  browser.click(box[0].get<double>() + share * box[1].get<double>(), box[2]);
  EXPECT_TRUE(browser.wait_for(kAllStand));
}

/// The value of a column of the series at the last row of that time.
double series_at(const std::filesystem::path& file, const std::string& header, double time_s) {
  io::CsvReader csv(file);
  const std::size_t time = *csv.find("time_s");
  const std::size_t wanted = *csv.find(header);
  double found = std::nan("");
  while (csv.next()) {
    if (csv.number(time) <= time_s + 1e-6) found = csv.number(wanted);
  }
  return found;
}

TEST_F(HopperPage, AClickOnTheSliderMovesAllThatIsDrawn) {
  open(kWide);
  click_slider(browser(), 0.1);
  const json before = browser().value_of(kDrawn);
  const json words =
      browser().value_of("document.getElementById('time').getAttribute('aria-valuetext')");
  click_slider(browser(), 0.37);
  const json after = browser().value_of(kDrawn);
  ASSERT_EQ(before.size(), after.size());
  EXPECT_NE(words,
            browser().value_of("document.getElementById('time').getAttribute('aria-valuetext')"));
  // Each of the kinds: bones, centre of mass, forces, and a mark in every chart.
  const json charts = browser().value_of("document.querySelectorAll('svg.chart').length");
  EXPECT_EQ(charts, 3 * 3 + 4);  // three drives; bus, force, CAM, CAV
  std::size_t moved = 0;
  for (std::size_t i = 0; i < after.size(); ++i) moved += before[i] != after[i] ? 1 : 0;
  EXPECT_GT(moved, 0.9 * static_cast<double>(after.size()));
}

TEST_F(HopperPage, MarksStandWhereTheSeriesSays) {
  open(kWide);
  for (const double share : {0.2, 0.36, 0.5, 0.9}) {
    click_slider(browser(), share);
    const double time_s =
        browser().value_of("Number(document.getElementById('clock').textContent.split(' ')[0])");
    const double exact_s = browser().value_of(
        "(() => { const d = document.querySelector('circle.now[data-x=\"time_s\"]');"
        "const c = d.ownerSVGElement.dataset;"
        "return (d.getAttribute('cx') - c.xZero) / c.xSlope; })()");
    EXPECT_NEAR(exact_s, time_s, 6e-4);  // three decimals are shown
    for (const char* header : {"knee_drive_torque_Nm", "knee_gear_motor_torque_Nm",
                               "knee_bus_voltage_V", "ankle_left_drive_torque_Nm"}) {
      const double drawn = browser().value_of(
          fmt::format("(() => {{ const d = "
                      "document.querySelector('circle.now[data-x=\"time_s\"][data-y=\"{}\"]');"
                      "const c = d.ownerSVGElement.dataset;"
                      "return (d.getAttribute('cy') - c.yZero) / c.ySlope; }})()",
                      header));
      const double told = series_at(place().path("series.csv"), header, exact_s);
      EXPECT_NEAR(drawn, told, 1e-4 * std::max(1.0, std::abs(told))) << header << exact_s;
    }
  }
}

TEST_F(HopperPage, ShowsViolationsInRed) {
  open(kWide);
  const auto bad_bones = [] {
    return browser().value_of("document.querySelectorAll('svg.robot .bone.bad').length").get<int>();
  };
  const auto told = [] {
    return browser().value_of("document.getElementById('violated').textContent").get<std::string>();
  };
  EXPECT_GT(bad_bones(), 0);  // it begins where it is worst
  EXPECT_NE(told().find("knee motor operating region"), std::string::npos);
  EXPECT_EQ(browser().value_of("document.querySelectorAll('circle.now.bad').length"), 2);
  click_slider(browser(), 0.1);
  EXPECT_EQ(bad_bones(), 0);
  EXPECT_EQ(told(), "");
  EXPECT_EQ(browser().value_of("document.querySelectorAll('circle.now.bad').length"), 0);
  // Of the 26 clipped samples and the 28 too fast ones the track shows two bands.
  EXPECT_EQ(browser().value_of("document.querySelectorAll('.track .violated').length"), 2);
  browser().value_of("document.getElementById('after').click()");
  EXPECT_NEAR(browser().value_of(kTime).get<double>(), 0.612115, 1e-5);
  EXPECT_GT(bad_bones(), 0);
}

TEST_F(HopperPage, IsUsedWithoutAMouse) {
  open(kWide);
  std::set<std::string> reached;
  for (int i = 0; i < 6; ++i) {
    browser().press("Tab");
    reached.insert(browser().value_of("document.activeElement.id").get<std::string>());
  }
  for (const char* id : {"play", "speed", "before", "after", "time"}) {
    EXPECT_TRUE(reached.contains(id)) << id;
  }
  browser().value_of("document.getElementById('time').focus()");
  browser().press("ArrowRight");
  EXPECT_NEAR(browser().value_of(kTime).get<double>(), 0.614, 0.002);  // the sample after the worst
  browser().press("End");
  EXPECT_NEAR(browser().value_of(kTime).get<double>(), 1.7339, 1e-4);
  browser().value_of("document.getElementById('play').focus()");
  browser().press(" ");  // from the begin, since it stood at the end
  EXPECT_EQ(browser().value_of("document.getElementById('play').textContent"), "Pause");
  EXPECT_TRUE(browser().wait_for(std::string(kTime) + " > 0.1"));
  browser().press(" ");
  EXPECT_EQ(browser().value_of("document.getElementById('play').textContent"), "Play");
  const json stands = browser().value_of(kTime);
  EXPECT_TRUE(
      browser().wait_for("document.getElementById('spoken').textContent.includes('knee: ')"));
  EXPECT_EQ(browser().value_of(kTime), stands);
}

TEST_F(HopperPage, PlaysSlowlyByTheClock) {
  open(kWide);
  browser().value_of(
      "(() => { const s = document.getElementById('speed'); s.value = '0.05';"
      "s.dispatchEvent(new Event('change'));"
      "const t = document.getElementById('time'); t.value = 0; t.dispatchEvent(new Event('input'));"
      "window.begun = performance.now(); document.getElementById('play').click(); })()");
  EXPECT_TRUE(browser().wait_for(std::string(kTime) + " > 0.03"));
  // At most a twentieth of the time that has gone by: the drawn frame may be an old one.
  const double share = browser().value_of(
      "Number(document.getElementById('time').value) * 1000 / (performance.now() - window.begun)");
  EXPECT_LT(share, 0.051);
}

TEST_F(HopperPage, FitsANarrowWindow) {
  open(kNarrow);
  EXPECT_LE(browser().value_of("document.documentElement.scrollWidth").get<int>(), kNarrow);
  EXPECT_EQ(browser().value_of("[...document.querySelectorAll('body *')].filter((e) => "
                               "e.getBoundingClientRect().right > innerWidth + 0.5).map((e) => "
                               "e.outerHTML.slice(0, 90))"),
            json::array());
  // Fingers need some room, words some size.
  EXPECT_GE(browser()
                .value_of("Math.min(...[...document.querySelectorAll('.player button')]"
                          ".map((b) => b.getBoundingClientRect().height))")
                .get<double>(),
            36.0);
}

TEST_F(HopperPage, AsksNoNetworkAndComplainsOfNothing) {
  open(kWide);
  click_slider(browser(), 0.5);
  ASSERT_EQ(browser().requests().size(), 1u);
  EXPECT_TRUE(browser().requests().front().ends_with("/page.html"));
  EXPECT_TRUE(browser().complaints().empty()) << browser().complaints().front();
}

TEST_F(HopperPage, StandsWithoutScripts) {
  browser().allow_scripts(false);
  open(kWide);
  const json drawn = browser().value_of(
      "[...document.querySelectorAll('svg.chart, svg.robot, svg.still')].filter((e) => "
      "e.getBoundingClientRect().height > 50).length");
  const json controls = browser().value_of(
      "[...document.querySelectorAll('.needs-script')].filter((e) => "
      "e.getBoundingClientRect().height > 0).length");
  browser().allow_scripts(true);
  EXPECT_EQ(drawn, 13 + 1 + 12);
  EXPECT_EQ(controls, 0);
}

TEST_F(HopperPage, DrawsHalfOfTheMomentsInFlight) {
  open(kWide);
  EXPECT_EQ(browser().value_of("document.querySelectorAll('.moment.flight').length"), 6);
  EXPECT_EQ(browser().value_of("document.querySelectorAll('.moment.ground').length"), 6);
}

// Whatever a person may use or must know has a name in the tree that screen readers read.
TEST_F(HopperPage, NamesWhatAScreenReaderMeets) {
  open(kWide);
  const json tree = browser().call("Accessibility.getFullAXTree")["nodes"];
  std::set<std::string> named;
  for (const json& node : tree) {
    if (node.value("ignored", false)) continue;
    const std::string role = node["role"].value("value", "");
    if (role != "button" && role != "slider" && role != "combobox" && role != "image") continue;
    EXPECT_NE(node["name"].value("value", ""), "") << node.dump();
    named.insert(role);
  }
  EXPECT_EQ(named, (std::set<std::string>{"button", "combobox", "image", "slider"}));
  EXPECT_EQ(browser().value_of("document.getElementById('time').getAttribute('aria-valuetext')"),
            "0.6121 seconds, on the ground, knee motor operating region, knee joint speed");
  ASSERT_TRUE(browser().wait_for("document.getElementById('spoken').textContent !== ''"));
  EXPECT_EQ(browser().value_of("document.getElementById('spoken').textContent"),
            "0.6121 seconds; on the ground; violated: knee: motor operating region, knee: joint "
            "speed; knee: -312 newton metres at -11.9 radians per second, outside its region; "
            "ankle_left: -76.4 newton metres at -2.95 radians per second, inside its region; "
            "ankle_right: -76.4 newton metres at -2.94 radians per second, inside its region");
}

// Where nothing says how the base moves there is no figure and no ground; the drives' marks move.
TEST_F(HopperPage, ShowsDrivesAloneWhereTheBaseIsNotKnown) {
  std::string motion =
      "time_s,knee_position_rad,ankle_pitch_position_rad,ankle_roll_position_rad,"
      "knee_torque_Nm,ankle_pitch_torque_Nm,ankle_roll_torque_Nm\n";
  for (int i = 0; i <= 200; ++i) {
    const double time_s = 0.005 * i;
    motion += fmt::format("{0},{1},0,0,{2},1,0\n", time_s, 0.5 + 0.3 * std::sin(6 * time_s),
                          40 * std::sin(9 * time_s));
  }
  place().write("drives.csv", motion);
  const auto outcome =
      place().run({"hopper", "check", in_repository("specs/robot/hopper.json").string(),
                   "drives.csv", "--report", "drives.html"});
  ASSERT_NE(outcome.exit_code, 2) << outcome.err;
  browser().open(place().path("drives.html"), kNarrow, 900);
  click_slider(browser(), 0.3);
  const json before = browser().value_of(kDrawn);
  click_slider(browser(), 0.6);
  EXPECT_NE(before, browser().value_of(kDrawn));
  EXPECT_EQ(browser().value_of("document.querySelectorAll('svg.robot, svg.still').length"), 0);
  EXPECT_EQ(browser().value_of("document.getElementById('phase').textContent"), "");
  EXPECT_LE(browser().value_of("document.documentElement.scrollWidth").get<int>(), kNarrow);
  EXPECT_TRUE(browser().complaints().empty()) << browser().complaints().front();
}

// Names that would end the element that holds the numbers, an attribute, or a line of JavaScript.
TEST_F(HopperPage, RunsNothingOutOfNames) {
  const std::string hostile =
      "</script><script>window.injected = 1</script>\"'><img src=x onerror=window.injected=1>"
      ";//&amp;${window.injected=1}";
  json robot = json::parse(text_of(in_repository("specs/robot/hopper.json")));
  robot["name"] = hostile;
  robot.erase("assumed");
  for (json& mechanism : robot["mechanisms"]) mechanism.erase("transmission_limit");
  robot["mechanisms"][1]["actuator_names"] = {hostile, "ankle_right"};
  robot["contacts"][0]["name"] = hostile;
  const std::filesystem::path actuators = in_repository("specs/actuator");
  robot["mechanisms"][0]["actuators"] = {(actuators / "d151_knee.json").string()};
  robot["mechanisms"][1]["actuators"] = {(actuators / "d110a_ankle.json").string(),
                                         (actuators / "d110a_ankle.json").string()};
  place().write("hostile.json", robot.dump());
  const auto outcome = place().run({"hopper", "check", "hostile.json",
                                    in_repository("specs/trajectory/hopper_flip.csv").string(),
                                    "--report", "hostile.html"});
  ASSERT_EQ(outcome.exit_code, 1) << outcome.err;
  browser().open(place().path("hostile.html"), kWide, 900);
  click_slider(browser(), 0.37);
  EXPECT_EQ(browser().value_of("typeof window.injected"), "undefined");
  EXPECT_EQ(browser().value_of("document.querySelectorAll('img').length"), 0);
  EXPECT_TRUE(browser().complaints().empty()) << browser().complaints().front();
  EXPECT_EQ(browser().requests().size(), 1u);
  EXPECT_EQ(browser().value_of(
                "JSON.parse(document.getElementById('motion').textContent).drives[1].name"),
            hostile);
  EXPECT_EQ(browser().value_of("document.querySelectorAll('script').length"), 4);
}

}  // namespace
}  // namespace torquewright::page_test
