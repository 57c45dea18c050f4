// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/region_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "src/report/actuator/region_lines.hpp"

namespace torquewright::report {
namespace {

using namespace actuator;

constexpr int kRegionWidth = 960;
constexpr int kRegionHeight = 680;
constexpr int kPanelWidth = 560;
constexpr int kRegionPanelHeight = 430;
constexpr const char* kShade = "#eef1f4";

/// Axes through zero, a light grid, names with units.
std::string axes() {
  return "set grid back linecolor rgb '#dddddd' linewidth 1\n"
         "set xzeroaxis linetype 1 linecolor rgb '#888888' linewidth 1\n"
         "set yzeroaxis linetype 1 linecolor rgb '#888888' linewidth 1\n"
         "set xlabel 'speed in rad/s' offset 0,0.4\nset ylabel 'torque in Nm'\n"
         "set border linecolor rgb '#555555'\nset tics nomirror\n"
         "set datafile separator ','\n";
}

/// Where torque and speed have one sign the drive drives, else it brakes. Above the shade.
std::string quadrant_names() {
  std::string script = "set grid front linecolor rgb '#c3cbd3' linewidth 0.7 linetype 1\n";
  for (const auto& [x, y, side, words] : {std::tuple{0.985, 0.965, "right", "driving"},
                                          {0.015, 0.965, "left", "braking"},
                                          {0.015, 0.035, "left", "driving"},
                                          {0.985, 0.035, "right", "braking"}}) {
    script += fmt::format("set label '{}' at graph {},{} {} front textcolor rgb '#49566b'\n", words,
                          x, y, side);
  }
  return script;
}

using Bound = JointBound JointRange::*;

/// Rows of a bound at which its line bends where its limiter changes, and the ends of the region.
std::vector<std::size_t> corners_of(const MorTable& table, Bound bound) {
  std::vector<std::size_t> filled;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (!table.rows[i].range.is_empty) filled.push_back(i);
  }
  std::vector<std::size_t> corners;
  if (filled.size() < 2) return corners;
  const auto torque_Nm = [&](std::size_t k) {
    return (table.rows[filled[k]].range.*bound).torque_Nm;
  };
  const auto slope = [&](std::size_t k) {
    return (torque_Nm(k) - torque_Nm(k - 1)) /
           (table.rows[filled[k]].speed_rad_s - table.rows[filled[k - 1]].speed_rad_s);
  };
  for (std::size_t k = 1; k < filled.size(); ++k) {
    const auto limiter = [&](std::size_t at) {
      return (table.rows[filled[at]].range.*bound).limiter;
    };
    if (limiter(k) == limiter(k - 1)) continue;
    // The row before the change is the corner itself where the line bends there already.
    const bool bends_before =
        k > 1 && std::abs(slope(k) - slope(k - 1)) > 1e-6 * (std::abs(slope(k)) + 1e-9);
    corners.push_back(filled[bends_before ? k - 1 : k]);
  }
  const bool is_upper = bound == &JointRange::greatest;
  corners.push_back(is_upper ? filled.front() : filled.back());
  return corners;
}

/// Corners of a region with their values, written inside it.
std::string corner_values(const MorTable& table) {
  constexpr std::size_t kMostCorners = 5;  // of a bound: more would hide it
  std::string script;
  for (const Bound bound : {&JointRange::greatest, &JointRange::least}) {
    const std::vector<std::size_t> corners = corners_of(table, bound);
    if (corners.size() > kMostCorners) continue;
    for (const std::size_t row : corners) {
      const double speed_rad_s = table.rows[row].speed_rad_s;
      const double torque_Nm = (table.rows[row].range.*bound).torque_Nm;
      script += fmt::format(
          "set label '{:.4g} Nm at {:.3g} rad/s' at {:.9g},{:.9g} {} front point pointtype 7 "
          "pointsize 0.9 offset {},{} font ',11'\n",
          torque_Nm, speed_rad_s, speed_rad_s, torque_Nm, speed_rad_s > 0.0 ? "right" : "left",
          speed_rad_s > 0.0 ? -1.8 : 1.8, bound == &JointRange::greatest ? -1.0 : 1.0);
    }
  }
  return script;
}

/// Room around all that is drawn, so that no bound lies on the frame.
std::string ranges(double speed_low, double speed_high, double torque_low, double torque_high) {
  const double speed_room = 0.06 * (speed_high - speed_low);
  const double torque_room = 0.10 * (torque_high - torque_low);
  return fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n",
                     speed_low - speed_room, speed_high + speed_room, torque_low - torque_room,
                     torque_high + torque_room);
}

struct Extent {
  double speed_low = 0.0;
  double speed_high = 0.0;
  double torque_low = 0.0;
  double torque_high = 0.0;

  void include(double speed_rad_s, double torque_Nm) {
    speed_low = std::min(speed_low, speed_rad_s);
    speed_high = std::max(speed_high, speed_rad_s);
    torque_low = std::min(torque_low, torque_Nm);
    torque_high = std::max(torque_high, torque_Nm);
  }
  void include(const MorTable& table) {
    for (const MorRow& row : table.rows) {
      if (row.range.is_empty) continue;
      include(row.speed_rad_s, row.range.least.torque_Nm);
      include(row.speed_rad_s, row.range.greatest.torque_Nm);
    }
  }
  std::string as_ranges() const { return ranges(speed_low, speed_high, torque_low, torque_high); }
};

std::string need_words(const PlottedNeed& need) {
  const std::string asked =
      fmt::format("needed: {:.4g} Nm at {:.4g} rad/s", need.torque_Nm, need.speed_rad_s);
  if (!std::isfinite(need.margin_Nm)) return asked + ", no torque is there";
  return asked + (need.margin_Nm >= 0.0 ? fmt::format(", margin {:.4g} Nm", need.margin_Nm)
                                        : fmt::format(", {:.4g} Nm missing", -need.margin_Nm));
}

/// The point, its words, and the way to the bound.
std::string need_mark(const PlottedNeed& need, const Extent& extent) {
  const char* color = need.margin_Nm >= 0.0 ? "#00795a" : "#b3261e";
  const bool is_right = need.speed_rad_s > 0.5 * (extent.speed_low + extent.speed_high);
  std::string script = fmt::format(
      "set label {} at {:.9g},{:.9g} {} front point pointtype 13 pointsize 1.6 linecolor rgb '{}' "
      "offset {},0.2 textcolor rgb '{}' font ',12'\n",
      gnuplot_quoted(need_words(need)), need.speed_rad_s, need.torque_Nm,
      is_right ? "right" : "left", color, is_right ? -1.8 : 1.8, color);
  if (!std::isfinite(need.margin_Nm) || need.margin_Nm == 0.0) return script;
  return script + fmt::format(
                      "set arrow from {0:.9g},{1:.9g} to {0:.9g},{2:.9g} heads size screen "
                      "0.008,25 front linewidth 1.5 linecolor rgb '{3}'\n",
                      need.speed_rad_s, need.torque_Nm, need.bound_Nm, color);
}

void append(std::vector<std::string>& plots, std::vector<std::string> more) {
  plots.insert(plots.end(), more.begin(), more.end());
}

std::string plot_command(const std::vector<std::string>& plots) {
  std::string command = "plot ";
  for (std::size_t i = 0; i < plots.size(); ++i) {
    command += (i > 0 ? ", \\\n  " : "") + plots[i];
  }
  return command + "\n";
}

/// Data and plots of the motion: the path coloured by time, what lies outside ringed.
std::string trace_data(const std::vector<TracePoint>& trace, std::size_t panel) {
  std::string text = fmt::format("$trace{} << END\n", panel);
  for (const TracePoint& point : trace) {
    text += fmt::format("{:.7g},{:.7g},{:.7g},{}\n", point.speed_rad_s, point.torque_Nm,
                        point.time_s, point.is_outside ? 1 : 0);
  }
  return text + "END\n";
}

std::string motion_panel(const PlottedMotion& motion, std::size_t panel) {
  Extent extent;
  extent.include(motion.region);
  std::size_t outside = 0;
  for (const TracePoint& point : motion.trace) {
    extent.include(point.speed_rad_s, point.torque_Nm);
    if (point.is_outside) ++outside;
  }
  const RegionLines lines(motion.region, fmt::format("r{}", panel));
  std::string script = "set title " + gnuplot_quoted(motion.title) + "\n" + extent.as_ranges();
  script += lines.data();
  std::vector<std::string> plots{lines.shade(kShade)};
  append(plots, lines.plots(2.0, 1));
  if (!motion.trace.empty()) {
    script += trace_data(motion.trace, panel);
    const std::string data = fmt::format("$trace{}", panel);
    plots.push_back(data +
                    " using 1:2:3 with linespoints pointtype 7 pointsize 0.28 linewidth 0.8 "
                    "linecolor palette notitle 'the motion, coloured by its time'");
    if (outside > 0) {
      plots.push_back(data +
                      " using ($4 == 1 ? $1 : NaN):2 with points pointtype 6 pointsize 0.8 "
                      "linewidth 1.2 linecolor rgb '#d00000' title 'outside the region'");
    }
  }
  append(plots, limiter_key({{"", motion.region}}));
  return script + plot_command(plots);
}

}  // namespace

std::string region_plot(PlotFormat format, const std::string& title,
                        const std::vector<PlottedRegion>& regions,
                        const std::optional<PlottedNeed>& need) {
  std::string script = gnuplot_terminal(format, kRegionWidth, kRegionHeight) + axes();
  script += "set title " + gnuplot_quoted(title) + "\n";
  script += "set key below horizontal spacing 1.3\nset bmargin 8\nset rmargin 4\n";
  script += quadrant_names();
  if (!regions.empty()) script += corner_values(regions.front().table);
  Extent extent;
  std::vector<std::string> plots;
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    extent.include(regions[i].table);
    const RegionLines lines(regions[i].table, fmt::format("r{}", i), regions[i].has_battery);
    script += lines.data();
    if (i == 0) plots.push_back(lines.shade(kShade));
    const double width = i == 0 ? 3.0 : 1.6;
    append(plots, lines.plots(width, i + 1));
    if (regions.size() > 1) keys.push_back(label_key(regions[i].label, width, i + 1));
  }
  append(plots, keys);
  append(plots, limiter_key(regions));
  if (need) {
    extent.include(need->speed_rad_s, need->torque_Nm);
    script += need_mark(*need, extent);
  }
  return script + extent.as_ranges() + plot_command(plots);
}

std::string motion_plot(PlotFormat format, const std::string& title,
                        const std::vector<PlottedMotion>& motions) {
  const auto count = static_cast<int>(motions.size());
  const int columns = count == 1 ? 1 : 2;
  const int rows = (count + columns - 1) / columns;
  const int width = count == 1 ? kRegionWidth : columns * kPanelWidth;
  const int height = count == 1 ? kRegionHeight : rows * kRegionPanelHeight + 40;
  std::string script = gnuplot_terminal(format, width, height) + axes();
  script += gnuplot_palette();
  script += "set cblabel 'time in s'\nset key below horizontal samplen 2\nset bmargin 5\n";
  double first_s = 0.0;
  double last_s = 0.0;
  bool has_times = false;
  for (const PlottedMotion& motion : motions) {
    if (motion.trace.empty()) continue;
    first_s =
        has_times ? std::min(first_s, motion.trace.front().time_s) : motion.trace.front().time_s;
    last_s = std::max(last_s, motion.trace.back().time_s);
    has_times = true;
  }
  if (last_s > first_s) script += fmt::format("set cbrange [{:.9g}:{:.9g}]\n", first_s, last_s);
  script +=
      fmt::format("set multiplot layout {},{} title {}\n", rows, columns, gnuplot_quoted(title));
  for (std::size_t i = 0; i < motions.size(); ++i) script += motion_panel(motions[i], i);
  return script + "unset multiplot\n";
}

}  // namespace torquewright::report
