// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/cursor_player.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

constexpr double kTrackWidth = 1000;
constexpr double kLeastWidth = 3;  // of what happens in an instant

std::string track_svg(const Track& track) {
  const double scale = kTrackWidth / std::max(track.until_s - track.from_s, 1e-9);
  std::string text =
      fmt::format("<svg aria-hidden=\"true\" viewBox=\"0 0 {} 10\" preserveAspectRatio=\"none\">\n",
                  kTrackWidth);
  const auto mark = [&](const char* style, double from_s, double until_s) {
    const double left = (from_s - track.from_s) * scale;
    const double width = std::max(kLeastWidth, (until_s - from_s) * scale);
    text += svg_rectangle(style, {std::min(left, kTrackWidth - kLeastWidth), 0.0}, {width, 10.0});
  };
  for (const Interval& flight : track.flights) mark("flight", flight.from_s, flight.until_s);
  for (const double impact_s : track.impacts_s) mark("impact", impact_s, impact_s);
  for (const ShownViolation& violation : track.violations) {
    for (const Interval& time : violation.times) mark("violated", time.from_s, time.until_s);
  }
  return text + "</svg>\n";
}

std::string cell(const ShownValue& value) {
  return fmt::format("<td data-column=\"{}\" data-bad=\"{}\"></td>", escaped(value.column),
                     escaped(value.bad));
}

std::string drives_table(const DriveValues& drives) {
  if (drives.rows.empty()) return "";
  std::string text =
      "<table class=\"now-values\">\n<caption class=\"spoken\">Drives at the time of the "
      "cursor</caption>\n<tr><th scope=\"col\">drive</th>";
  for (const std::string& heading : drives.headings) {
    text += fmt::format("<th scope=\"col\">{}</th>", escaped(heading));
  }
  text += "</tr>\n";
  for (const DriveValues::Row& row : drives.rows) {
    text += fmt::format("<tr><th scope=\"row\">{}</th>", escaped(row.drive));
    for (const ShownValue& value : row.values) text += cell(value);
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

}  // namespace

std::string cursor_player(const Track& track) {
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
      track.from_s, track.until_s, track_svg(track));
}

std::string cursor_values(const hopper::Series& series, const DriveValues& drives,
                          const std::vector<Quantity>& quantities) {
  std::string text = "<div class=\"needs-script\" hidden>\n" + drives_table(drives) +
                     "<dl class=\"quantities\">\n";
  for (const Quantity& quantity : quantities) {
    if (hopper::find_column(series, quantity.column) == nullptr) continue;
    text += fmt::format("<div><dt>{}</dt><dd data-column=\"{}\"></dd></div>\n",
                        escaped(quantity.words), escaped(quantity.column));
  }
  return text + "</dl>\n</div>\n";
}

}  // namespace torquewright::report
