// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "src/report/robot/calibration_text.hpp"

namespace torquewright::report {
namespace {

namespace calibration = hopper::calibration;

constexpr int kValleyWidth = 460;
constexpr int kValleyHeight = 300;
constexpr int kValleyTitle = 40;
constexpr const char* kProfileColor = "#0072b2";
constexpr const char* kMetColor = "#d7ecd9";
constexpr const char* kFittedColor = "#d55e00";

/// Errors far above the tolerance say no more than that: the curve is cut there.
double highest_percent(const CalibrationReport& report) {
  return 12.0 * 100.0 * report.question.figures.tolerance;
}

std::string profile_data(const calibration::Profile& profile, std::size_t index) {
  std::string text = fmt::format("$p{} << END\n", index);
  for (const calibration::ProfilePoint& point : profile.points) {
    if (point.best) {
      text += fmt::format("{:.9g} {:.9g}\n", point.value, 100.0 * point.best->worst_error);
    }
  }
  return text + "END\n";
}

std::string valley_panel(const CalibrationReport& report, std::size_t index) {
  const calibration::Profile& profile = report.found.profiles[index];
  const calibration::FreeValue& free = report.question.free[index];
  const double top = highest_percent(report);
  std::string text = "unset object\nunset arrow\n";
  int object = 0;
  for (const calibration::Profile::Range& range : profile.ranges) {
    text += fmt::format(
        "set object {} rectangle from {:.9g},0 to {:.9g},{:.9g} fillcolor rgb '{}' "
        "fillstyle solid noborder behind\n",
        ++object, range.low, range.high, top, kMetColor);
  }
  const double fitted = report.found.best->values[index];
  text +=
      fmt::format("set arrow from {:.9g},0 to {:.9g},{:.9g} nohead linecolor rgb '{}' dashtype 2\n",
                  fitted, fitted, top, kFittedColor);
  text += fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [0:{:.9g}]\nset xlabel {}\n",
                      free.lowest, free.highest, top, gnuplot_quoted(free.words));
  text += fmt::format(
      "plot $p{} using 1:2 with linespoints pointtype 7 pointsize 0.4 linewidth 2 "
      "linecolor rgb '{}' notitle 'error of the figures', {:.9g} with lines dashtype 3 linecolor "
      "rgb "
      "'#888888' notitle 'their tolerance'\n",
      index, kProfileColor, 100.0 * report.question.figures.tolerance);
  return text;
}

}  // namespace

std::string calibration_plot(const CalibrationReport& report, PlotFormat format) {
  const std::size_t count = report.found.profiles.size();
  const std::size_t columns = std::min<std::size_t>(count, 2);
  const std::size_t rows = (count + columns - 1) / columns;
  std::string script = gnuplot_terminal(format, static_cast<int>(columns) * kValleyWidth,
                                        static_cast<int>(rows) * kValleyHeight + kValleyTitle);
  script +=
      "set border linecolor rgb '#555555'\nset tics nomirror\nset grid back linecolor rgb "
      "'#dddddd'\nset ylabel 'worst error in %'\n";
  for (std::size_t i = 0; i < count; ++i) script += profile_data(report.found.profiles[i], i);
  script += fmt::format(
      "set multiplot layout {},{} title {}\n", rows, columns,
      gnuplot_quoted(report.robot +
                     ": where the figures can be met (green), the other values fitted"));
  for (std::size_t i = 0; i < count; ++i) script += valley_panel(report, i);
  return script + "unset multiplot\n";
}

}  // namespace torquewright::report
