// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/sweep_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::report {
namespace {

using sweep::RowVerdict;
using sweep::Swept;
using sweep::SweptAxis;
using sweep::SweptPoint;

constexpr int kSweepWidth = 960;
constexpr int kHeight = 620;
constexpr const char* kLine = "#0072b2";
constexpr const char* kPresent = "#888888";

/// How points of a verdict look. A cross on a map must be seen on every colour.
struct Mark {
  RowVerdict verdict;
  int point_type;  ///< gnuplot's: 2 a cross, 5 a square, 7 a disc, 8 a triangle.
  const char* color;
};
constexpr Mark kMarks[]{{RowVerdict::kPasses, 7, "#1a7f37"},
                        {RowVerdict::kFails, 2, "#d00000"},
                        {RowVerdict::kOpen, 8, "#b58900"},
                        {RowVerdict::kRefused, 4, "#555555"}};

std::optional<double> shown(const SweptPoint& point) {
  if (!point.row || point.row->measures.empty()) return std::nullopt;
  return point.row->measures.front().value;
}

std::string measure_name(const Swept& swept) {
  for (const SweptPoint& point : swept.points) {
    if (shown(point)) return point.row->measures.front().name;
  }
  return "";
}

std::string label_of(const SweptAxis& axis) {
  return axis.unit.empty() ? axis.name : fmt::format("{} in {}", axis.name, axis.unit);
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.9g}", *value) : std::string("NaN");
}

std::string title_of(const Swept& swept) {
  std::string what = swept.axes.front().name;
  if (swept.axes.size() > 1) what += " and " + swept.axes.back().name;
  return fmt::format("{}: {} over {}", swept.subject, swept.command, what);
}

/// Data of the points of each verdict, in blocks named by it.
std::string mark_data(const Swept& swept) {
  std::string text;
  for (const Mark& mark : kMarks) {
    text += fmt::format("${} << END\n", name_of(mark.verdict));
    for (const SweptPoint& point : swept.points) {
      if (!point.row || point.row->verdict != mark.verdict) continue;
      // What has no number stands on the ground line of a chart.
      const std::string second = swept.axes.size() > 1 ? fmt::format("{:.9g}", point.values[1])
                                                       : number(shown(point).value_or(0.0));
      text += fmt::format("{:.9g} {}\n", point.values[0], second);
    }
    text += "END\n";
  }
  return text;
}

std::string mark_plots(const Swept& swept) {
  std::string text;
  for (const Mark& mark : kMarks) {
    if (swept.count(mark.verdict) == 0) continue;
    text += fmt::format(
        ", \\\n  ${} using 1:2 with points pointtype {} pointsize 1.1 linewidth 2 linecolor rgb "
        "'{}' title '{}'",
        name_of(mark.verdict), mark.point_type, mark.color, name_of(mark.verdict));
  }
  return text;
}

std::string present_line(const SweptAxis& axis, bool is_upright) {
  if (!axis.present) return "";
  const bool is_inside =
      axis.values.front() <= *axis.present && *axis.present <= axis.values.back();
  if (!is_inside) return "";
  return is_upright ? fmt::format(
                          "set arrow from first {0:.9g}, graph 0 to first {0:.9g}, graph 1 nohead "
                          "dashtype 2 linecolor rgb '{1}' front\n",
                          *axis.present, kPresent)
                    : fmt::format(
                          "set arrow from graph 0, first {0:.9g} to graph 1, first {0:.9g} nohead "
                          "dashtype 2 linecolor rgb '{1}' front\n",
                          *axis.present, kPresent);
}

std::string beginning(PlotFormat format, const Swept& swept) {
  return gnuplot_terminal(format, kSweepWidth, kHeight) +
         "set grid back linecolor rgb '#dddddd' linewidth 1\nset border linecolor rgb '#555555'\n"
         "set tics nomirror\nset key below horizontal spacing 1.3\n" +
         fmt::format("set title {}\nset xlabel {}\n", gnuplot_quoted(title_of(swept)),
                     gnuplot_quoted(label_of(swept.axes.front())));
}

/// To either side of a value that stands alone: seen in the nine digits that gnuplot is given.
double width_alone(double value) { return std::max(0.05 * std::abs(value), 1e-9); }

std::string chart(const Swept& swept) {
  const SweptAxis& axis = swept.axes.front();
  const double width = axis.values.back() - axis.values.front();
  const double room = width > 0.0 ? 0.03 * width : width_alone(axis.values.front());
  std::string text = fmt::format(
      "set ylabel {}\nset offsets 0, 0, graph 0.06, graph 0.06\nset xrange [{:.9g}:{:.9g}]\n"
      "set xzeroaxis linetype 1 linecolor rgb '#888888' linewidth 1\n",
      gnuplot_quoted(measure_name(swept)), axis.values.front() - room, axis.values.back() + room);
  text += present_line(axis, true) + "$line << END\n";
  for (const SweptPoint& point : swept.points) {
    text += fmt::format("{:.9g} {}\n", point.values[0], number(shown(point)));
  }
  return text + "END\nplot $line using 1:2 with lines linewidth 2 linecolor rgb '" + kLine +
         "' notitle 'the answers'" + mark_plots(swept) + "\n";
}

/// Where the cells of values begin and end: half way to the neighbours.
std::vector<double> cell_edges(const std::vector<double>& values) {
  if (values.size() == 1) {
    const double half = width_alone(values.front());
    return {values.front() - half, values.front() + half};
  }
  std::vector<double> edges{1.5 * values[0] - 0.5 * values[1]};
  for (std::size_t i = 1; i < values.size(); ++i) {
    edges.push_back(0.5 * (values[i - 1] + values[i]));
  }
  edges.push_back(1.5 * values.back() - 0.5 * values[values.size() - 2]);
  return edges;
}

std::string cell_data(const Swept& swept, const std::vector<double>& x,
                      const std::vector<double>& y) {
  std::string text = "$cells << END\n";
  const std::size_t rows = swept.axes[1].values.size();
  for (std::size_t i = 0; i < swept.points.size(); ++i) {
    const auto value = shown(swept.points[i]);
    if (!value) continue;
    const std::size_t column = i / rows, row = i % rows;
    text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n",
                        swept.points[i].values[0], swept.points[i].values[1], x[column],
                        x[column + 1], y[row], y[row + 1], *value);
  }
  return text + "END\n";
}

std::string map(const Swept& swept) {
  const std::vector<double> x = cell_edges(swept.axes[0].values);
  const std::vector<double> y = cell_edges(swept.axes[1].values);
  std::string text = fmt::format(
      "set ylabel {}\nset cblabel {}\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n{}"
      "set style fill solid 0.75 noborder\n",
      gnuplot_quoted(label_of(swept.axes[1])), gnuplot_quoted(measure_name(swept)), x.front(),
      x.back(), y.front(), y.back(), gnuplot_palette());
  text += present_line(swept.axes[0], true) + present_line(swept.axes[1], false);
  return text + cell_data(swept, x, y) +
         "plot $cells using 1:2:3:4:5:6:7 with boxxyerror linecolor palette notitle 'the "
         "answers' " +
         mark_plots(swept) + "\n";
}

}  // namespace

std::string sweep_plot(PlotFormat format, const Swept& swept) {
  if (measure_name(swept).empty()) return "";
  const std::string data = mark_data(swept);
  return beginning(format, swept) + data + (swept.axes.size() > 1 ? map(swept) : chart(swept));
}

}  // namespace torquewright::report
