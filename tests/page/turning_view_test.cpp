// SPDX-License-Identifier: Apache-2.0
// The view of a page that turns, in a browser with WebGL and in one without. Oracles: the pixels
// that the browser draws, the columns of --series, the page's own layout and its network log.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/page/page_fixture.hpp"

namespace torquewright::page_test {
namespace {

using cli_test::in_repository;
using nlohmann::json;

constexpr int kDesk = 1100;
constexpr int kPhone = 390;

class TurningPage : public WrittenPage {
 protected:
  static void SetUpTestSuite() {
    if (!has_browser()) return;
    write_page(
        {"hopper", "check", in_repository("specs/robot/hopper.json").string(),
         in_repository("specs/trajectory/hopper_flip.csv").string(), "--report", "page.html"},
        Browser::Depth::kWebGl);
  }

  static void shown() {
    ASSERT_TRUE(browser().wait_for("document.querySelector('canvas').dataset.azimuth > 0"));
  }
  /// Once the view is drawn as it stands: pictures come a while after what they show.
  static void settle() {
    browser().value_of("document.querySelector('canvas').dataset.azimuth = ''");
    browser().value_of(
        "(() => { const c = document.querySelector('canvas');"
        "c.dispatchEvent(new PointerEvent('pointerleave')); })()");
    ASSERT_TRUE(browser().wait_for("document.querySelector('canvas').dataset.azimuth !== ''"));
  }
  /// The pointer there, and what it is told drawn.
  static void point(double x, double y) {
    browser().value_of("document.querySelector('canvas').dataset.azimuth = ''");
    browser().point(x, y);
    ASSERT_TRUE(browser().wait_for("document.querySelector('canvas').dataset.azimuth !== ''"));
  }
  static void move_to(double time_s) {
    browser().value_of(
        fmt::format("(() => {{ const t = document.getElementById('time'); t.value = {};"
                    "t.dispatchEvent(new Event('input')); }})()",
                    time_s));
    settle();
  }
  static double camera(const char* what) {
    return browser().value_of(
        fmt::format("Number(document.querySelector('canvas').dataset.{})", what));
  }
  /// Number and mean place (in parts of the height, from above) of the pixels in that colour's
  /// direction: [count, mean y].
  static json pixels(const char* is_it) {
    return browser().value_of(fmt::format(
        "(() => {{ const c = document.querySelector('canvas');"
        "const p = document.createElement('canvas'); p.width = c.width; p.height = c.height;"
        "const d = p.getContext('2d'); d.drawImage(c, 0, 0);"
        "const all = d.getImageData(0, 0, c.width, c.height).data; let n = 0; let sum = 0;"
        "for (let i = 0; i < all.length; i += 4) {{ const [r, g, b, a] = all.subarray(i, i + 4);"
        "if (a > 128 && ({})) {{ ++n; sum += Math.floor(i / 4 / c.width) / c.height; }} }}"
        "return [n, sum / n]; }})()",
        is_it));
  }
  static json box() {
    return browser().value_of(
        "(() => { const c = document.querySelector('canvas');"
        "c.scrollIntoView({block: 'center'}); const b = c.getBoundingClientRect();"
        "return [b.left + b.width / 2, b.top + b.height / 2, b.width, b.height]; })()");
  }
};

constexpr const char* kBlue = "b > 90 && b > 1.5 * r && b > g";
constexpr const char* kRed = "r > 90 && r > 3 * g && r > 3 * b";
constexpr const char* kGreen = "g > 60 && g > 1.6 * r && g > b";
constexpr const char* kPicture = "document.querySelector('canvas').toDataURL()";

TEST_F(TurningPage, ADragTurnsIt) {
  open(kDesk);
  shown();
  const json at = box();
  settle();
  const double azimuth = camera("azimuth");
  const double elevation = camera("elevation");
  const json before = browser().value_of(kPicture);
  browser().drag(at[0], at[1], at[0].get<double>() - 120, at[1].get<double>() + 60);
  settle();
  // A radian is 120 pixels.
  EXPECT_NEAR(camera("azimuth"), azimuth + 1.0, 1e-6);
  EXPECT_NEAR(camera("elevation"), elevation + 0.5, 1e-6);
  EXPECT_NE(browser().value_of(kPicture), before);
  // Taken hold of, it zooms with the wheel; with keys it turns.
  browser().call(
      "Input.dispatchMouseEvent",
      {{"type", "mouseWheel"}, {"x", at[0]}, {"y", at[1]}, {"deltaX", 0}, {"deltaY", -300}});
  ASSERT_TRUE(browser().wait_for("document.querySelector('canvas').dataset.zoom > 1.5"));
  browser().press("ArrowRight");
  settle();
  EXPECT_NEAR(camera("azimuth"), azimuth + 0.9, 1e-6);
  browser().value_of("document.querySelector('[data-look=side]').click()");
  settle();
  EXPECT_EQ(camera("azimuth"), 0.0);
}

TEST_F(TurningPage, BodiesMoveWithTheCursor) {
  open(kDesk);
  shown();
  browser().value_of("document.querySelector('[data-look=side]').click()");
  move_to(0.0);
  const json stands = pixels(kBlue);
  const json forces = pixels(kGreen);
  move_to(0.85);  // the middle of the flight, 0.66 to 1.13 s
  const json flies = pixels(kBlue);
  ASSERT_GT(stands[0], 500);
  ASSERT_GT(flies[0], 500);
  EXPECT_LT(flies[1].get<double>(), stands[1].get<double>() - 0.05);  // higher up in the picture
  EXPECT_GT(forces[0], 50);                                           // arrows on the ground alone
  EXPECT_EQ(pixels(kGreen)[0], 0);
  EXPECT_EQ(pixels(kRed)[0], 0);
  move_to(0.612115);
  EXPECT_GT(pixels(kRed)[0], 200);  // what violates its region
}

TEST_F(TurningPage, ThePointerIsToldValues) {
  open(kDesk);
  shown();
  const json at = box();
  settle();
  // From below upwards until it meets the robot.
  std::string told;
  for (int i = 0; i < 12 && told.empty(); ++i) {
    point(at[0], at[1].get<double>() + (6 - i) * 0.06 * at[3].get<double>());
    told = browser().value_of("document.querySelector('.hover').innerText").get<std::string>();
  }
  const bool is_body = told.find("thigh") == 0 || told.find("calf") == 0 ||
                       told.find("foot") == 0 || told.find("ankle_cross") == 0;
  const bool is_contact = told.find("heel") == 0 || told.find("toe") == 0;
  EXPECT_TRUE(is_body || is_contact) << told;
}

TEST_F(TurningPage, FitsANarrowWindowInTheDark) {
  browser().prefer_dark(true);
  open(kPhone);
  shown();
  const json dark = pixels("r + g + b < 120");
  browser().prefer_dark(false);
  EXPECT_LE(browser().value_of("document.documentElement.scrollWidth").get<int>(), kPhone);
  EXPECT_GT(browser().value_of("document.querySelector('canvas').getBoundingClientRect().height"),
            250);
  EXPECT_EQ(browser().value_of("getComputedStyle(document.querySelector('svg.robot')).display"),
            "none");
  settle();
  const json light = pixels("r + g + b < 120");
  EXPECT_GT(dark[0], light[0]);  // shadows are black there
}

TEST_F(TurningPage, RunsItsOwnScriptsAloneAndAsksNoNetwork) {
  open(kDesk);
  shown();
  EXPECT_EQ(browser().requests().size(), 1u);
  EXPECT_TRUE(browser().complaints().empty()) << browser().complaints().front();
  browser().value_of(
      "(() => { const s = document.createElement('script'); s.textContent = 'window.foreign = 1';"
      "document.body.append(s); })()");
  EXPECT_EQ(browser().value_of("typeof window.foreign"), "undefined");
}

TEST_F(TurningPage, IsPrintedFromTheSide) {
  open(kDesk);
  shown();
  browser().call("Emulation.setEmulatedMedia", {{"media", "print"}});
  const json side =
      browser().value_of("document.querySelector('svg.robot').getBoundingClientRect().height");
  const json view =
      browser().value_of("document.querySelector('.view').getBoundingClientRect().height");
  browser().call("Emulation.setEmulatedMedia", {{"media", ""}});
  EXPECT_GT(side, 50);
  EXPECT_EQ(view, 0);
}

TEST_F(TurningPage, WithoutWebglTheSideViewStandsAndThatIsSaid) {
  Browser flat(Browser::Depth::kNone);
  flat.open(place().path("page.html"), kPhone, 900);
  const auto height = [&flat](const char* selector) {
    return flat
        .value_of(
            fmt::format("document.querySelector('{}').getBoundingClientRect().height", selector))
        .get<double>();
  };
  EXPECT_GT(height("svg.robot"), 50.0);
  EXPECT_EQ(height(".view"), 0.0);
  EXPECT_GT(height(".no-webgl"), 10.0);
  EXPECT_LE(flat.value_of("document.documentElement.scrollWidth").get<int>(), kPhone);
  EXPECT_TRUE(flat.complaints().empty()) << flat.complaints().front();
  const json before = flat.value_of("document.querySelector('svg.robot .bone').outerHTML");
  flat.value_of(
      "(() => { const t = document.getElementById('time'); t.value = 0.1;"
      "t.dispatchEvent(new Event('input')); })()");
  EXPECT_NE(flat.value_of("document.querySelector('svg.robot .bone').outerHTML"), before);
}

}  // namespace
}  // namespace torquewright::page_test
