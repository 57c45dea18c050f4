// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/time_charts.hpp"

#include <fmt/format.h>

#include <set>

#include "src/report/parts/kept_samples.hpp"
#include "src/report/parts/page_parts.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kCurveBuckets = 400;  // about a point of the chart each

}  // namespace

const VectorXd& column(const hopper::Series& series, const std::string& header) {
  return *hopper::find_column(series, header);
}

Axis time_axis(const hopper::Series& series) {
  return axis_of("time in s", column(series, "time_s")).roomy(0.0);
}

std::vector<Index> drawn_samples(const VectorXd& values) {
  return curve_samples(values, kCurveBuckets);
}

std::vector<Index> drawn_samples(const VectorXd& one, const VectorXd& other) {
  const std::vector<Index> of_one = drawn_samples(one);
  const std::vector<Index> of_other = drawn_samples(other);
  std::set<Index> kept(of_one.begin(), of_one.end());
  kept.insert(of_other.begin(), of_other.end());
  return {kept.begin(), kept.end()};
}

void draw_curve(const hopper::Series& series, Chart& chart, const DrawnColumn& drawn) {
  const VectorXd& values = column(series, drawn.header);
  const std::vector<Index> kept = drawn_samples(values);
  chart.curve(drawn.style, column(series, "time_s")(kept), values(kept));
}

void draw_violations(const std::vector<ShownViolation>& violations, Chart& chart,
                     const std::string& name, std::string_view rule) {
  for (const ShownViolation& violation : violations) {
    if (violation.name != name || violation.rule != rule) continue;
    for (const Interval& time : violation.times) {
      chart.strip("violated", time.from_s, time.until_s);
    }
  }
}

void draw_cursor(Chart& chart, const std::vector<std::string>& headers, const std::string& bad) {
  chart.moving_line("time_s");
  for (const std::string& header : headers) chart.moving_dot("time_s", header, bad);
}

std::string time_chart(const hopper::Series& series, const std::string& heading,
                       const std::string& axis, const std::vector<DrawnColumn>& drawn,
                       const std::vector<double>& impacts_s) {
  Axis y = axis_of(axis, column(series, drawn.front().header));
  std::vector<std::string> headers;
  for (const DrawnColumn& each : drawn) {
    y.include(column(series, each.header));
    headers.push_back(each.header);
  }
  const double low = y.low;
  const double high = y.high;
  Chart chart(time_axis(series), y.roomy(kChartRoom));
  for (const double impact_s : impacts_s) chart.strip("impact", impact_s, impact_s);
  for (const DrawnColumn& each : drawn) draw_curve(series, chart, each);
  draw_cursor(chart, headers, "");
  return panel_of(heading, chart.svg(fmt::format("{}: {} over time, from {:.4g} to {:.4g}.",
                                                 heading, axis, low, high)));
}

}  // namespace torquewright::report
