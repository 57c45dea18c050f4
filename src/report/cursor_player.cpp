// SPDX-License-Identifier: Apache-2.0
#include "src/report/cursor_player.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/report/page_parts.hpp"
#include "src/report/svg.hpp"

namespace torquewright::report {
namespace {

constexpr double kTrackWidth = 1000;
constexpr double kLeastWidth = 3;  // of what happens in an instant

std::string track(const ChartSource& source) {
  const hopper::Motion& motion = source.page.motion;
  const double scale = kTrackWidth / std::max(motion.duration_s(), 1e-9);
  std::string text =
      fmt::format("<svg aria-hidden=\"true\" viewBox=\"0 0 {} 10\" preserveAspectRatio=\"none\">\n",
                  kTrackWidth);
  const auto mark = [&](const char* style, double from_s, double until_s) {
    const double left = (from_s - motion.times_s.front()) * scale;
    const double width = std::max(kLeastWidth, (until_s - from_s) * scale);
    text += svg_rectangle(style, {std::min(left, kTrackWidth - kLeastWidth), 0.0}, {width, 10.0});
  };
  for (const hopper::Flight& flight : source.page.report.flights) {
    mark("flight", flight.from_s, flight.until_s);
  }
  for (const hopper::Jolt& jolt : source.page.report.demand.jolts) {
    mark("impact", jolt.time_s, jolt.time_s);
  }
  for (const ShownViolation& violation : source.violations) {
    for (const Interval& time : violation.times) mark("violated", time.from_s, time.until_s);
  }
  return text + "</svg>\n";
}

std::string cell(const std::string& column, const std::string& bad = "") {
  return fmt::format("<td data-column=\"{}\" data-bad=\"{}\"></td>", escaped(column), escaped(bad));
}

std::string quantity(const ChartSource& source, const std::string& column,
                     const std::string& words) {
  if (hopper::find_column(source.series, column) == nullptr) return "";
  return fmt::format("<div><dt>{}</dt><dd data-column=\"{}\"></dd></div>\n", escaped(words),
                     escaped(column));
}

}  // namespace

std::string cursor_player(const ChartSource& source) {
  const hopper::Motion& motion = source.page.motion;
  return fmt::format(
      "<div class=\"player needs-script\" role=\"group\" aria-label=\"Time cursor\" hidden>\n"
      "<div class=\"row\">\n<button type=\"button\" id=\"play\">Play</button>\n"
      "<select id=\"speed\" aria-label=\"Speed of playing\">\n"
      "<option value=\"1\">real time</option>\n<option value=\"0.25\">1/4 speed</option>\n"
      "<option value=\"0.05\">1/20 speed</option>\n</select>\n"
      "<button type=\"button\" id=\"before\" aria-label=\"To the violation before\">&#8592; "
      "<span class=\"bad-mark\">!</span> <span class=\"word\">violation</span></button>\n"
      "<button type=\"button\" id=\"after\" aria-label=\"To the next violation\"><span "
      "class=\"bad-mark\">!</span> <span class=\"word\">violation</span> &#8594;</button>\n"
      "<span id=\"phase\"></span>\n<span id=\"clock\"></span>\n</div>\n"
      "<div class=\"track\">\n<input type=\"range\" id=\"time\" min=\"{0:.9g}\" max=\"{1:.9g}\" "
      "step=\"any\" value=\"{0:.9g}\" aria-label=\"Time in the motion, in seconds\"/>\n{2}</div>\n"
      "<ul id=\"violated\" aria-label=\"Violated at this time\"></ul>\n"
      "<p class=\"spoken\" id=\"spoken\" role=\"status\" aria-live=\"polite\"></p>\n</div>\n",
      motion.times_s.front(), motion.times_s.back(), track(source));
}

std::string cursor_values(const ChartSource& source) {
  const auto& drives = source.page.report.check.drives;
  std::string rows;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const std::string& name = drives[i].name;
    const std::string bad = outside_column(name);
    rows += fmt::format("<tr><th scope=\"row\">{}</th>{}{}{}{}</tr>\n", escaped(name),
                        cell(name + "_drive_speed_rad_s"), cell(name + "_drive_torque_Nm", bad),
                        cell(name + "_torque_margin_Nm", bad), cell(gear_column(source.page, i)));
  }
  std::string text = "<div class=\"needs-script\" hidden>\n";
  if (!rows.empty()) {
    text +=
        "<table class=\"now-values\">\n<caption class=\"spoken\">Drives at the time of the "
        "cursor</caption>\n<tr><th scope=\"col\">drive</th><th scope=\"col\">speed rad/s</th>"
        "<th scope=\"col\">torque Nm</th><th scope=\"col\">margin Nm</th><th scope=\"col\">gears "
        "Nm</th></tr>\n" +
        rows + "</table>\n";
  }
  std::string quantities;
  for (const hopper::SharedBus& bus : source.page.report.buses) {
    quantities += quantity(source, drives[bus.drives.front()].name + "_bus_voltage_V",
                           fmt::format("battery of {} drives, V", bus.drives.size()));
  }
  quantities += quantity(source, "ground_up_N", "ground pushes up, N") +
                quantity(source, "ground_forward_N", "ground pushes forward, N") +
                quantity(source, "cam_Nm_s", "CAM, Nm s") +
                quantity(source, "cav_rad_s", "CAV, rad/s");
  return text + "<dl class=\"quantities\">\n" + quantities + "</dl>\n</div>\n";
}

}  // namespace torquewright::report
