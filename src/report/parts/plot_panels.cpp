// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/plot_panels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace torquewright::report {
namespace {

using Eigen::Index;
using hopper::Motion;

constexpr Index kMostCurvePoints = 2000;
constexpr double kShortestAxis_s = 1e-3;  // of a motion of one row, which has no duration
constexpr int kWidth = 960;
constexpr int kPanelHeight = 230;

std::string data_of(const Motion& motion, const PlotPanel& panel, std::size_t index) {
  std::string text = fmt::format("$p{} << EOD\n", index);
  const Index stride = std::max<Index>(1, motion.samples() / kMostCurvePoints);
  for (Index sample = 0; sample < motion.samples(); sample += stride) {
    text += fmt::format("{:.9g}", motion.time_s(sample));
    for (const PlotCurve& curve : panel.curves) text += fmt::format(" {:.6g}", curve.at(sample));
    text += "\n";
  }
  return text + "EOD\n";
}

std::string panel_plot(const PlotPanel& panel, std::size_t index) {
  constexpr std::array kColours{"#1f5fa8", "#d96b0f", "#00795a", "#8a3ffc", "#b3261e", "#49566b"};
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    plots.push_back(
        fmt::format("$p{} using 1:{} with lines linewidth 1.6 linecolor rgb '{}' title {}", index,
                    i + 2, kColours[i % kColours.size()], gnuplot_quoted(panel.curves[i].label)));
  }
  return fmt::format("set ylabel {}\nplot {}\n", gnuplot_quoted(panel.axis),
                     fmt::join(plots, ", "));
}

std::string arrows_of(const std::vector<PlotMark>& marks) {
  std::string text;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    text += fmt::format(
        "set arrow {} from first {:.9g}, graph 0 to first {:.9g}, graph 1 nohead "
        "dashtype 2 linecolor rgb '#b3261e'\n",
        i + 1, marks[i].time_s, marks[i].time_s);
  }
  return text;
}

std::string words_of(const std::vector<PlotMark>& marks) {
  std::string text;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i].word.empty()) continue;
    text += fmt::format("set label {} {} at first {:.9g}, graph 0.06 offset 0.4,0\n", i + 1,
                        gnuplot_quoted(marks[i].word), marks[i].time_s);
  }
  return text;
}

}  // namespace

std::string panels_plot(PlotFormat format, const Motion& motion,
                        const std::vector<PlotPanel>& panels, const std::vector<PlotMark>& marks) {
  const auto count = static_cast<int>(panels.size());
  std::string script = gnuplot_terminal(format, kWidth, count * kPanelHeight);
  script +=
      "set grid linecolor rgb '#e6e6e6'\nset key above right horizontal samplen 1.5\nset lmargin "
      "11\nset rmargin 3\nset xlabel ''\n";
  for (std::size_t i = 0; i < panels.size(); ++i) script += data_of(motion, panels[i], i);
  script += arrows_of(marks);
  const double begin_s = motion.times_s.front();
  const double end_s = std::max(motion.times_s.back(), begin_s + kShortestAxis_s);
  script += fmt::format("set xrange [{:.17g}:{:.17g}]\nset multiplot layout {},1\n", begin_s, end_s,
                        count);
  script += words_of(marks);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (i + 1 == panels.size()) script += "set xlabel 'time in s'\n";
    script += panel_plot(panels[i], i);
    if (i == 0) script += "unset label\n";
  }
  return script + "unset multiplot\n";
}

}  // namespace torquewright::report
