// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Points on paper.
constexpr double kWidth = 400;
constexpr double kHeight = 220;
constexpr double kLeft = 46;
constexpr double kRight = 390;
constexpr double kTop = 26;
constexpr double kBottom = 184;
constexpr int kMostTicks = 6;

/// 1, 2 or 5 times a power of ten, so that there are few ticks.
double tick_step(const Axis& axis) {
  const double least = (axis.high - axis.low) / kMostTicks;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

std::vector<double> ticks(const Axis& axis) {
  const double step = tick_step(axis);
  std::vector<double> values;
  const auto first = static_cast<long>(std::ceil(axis.low / step - 1e-9));
  const auto last = static_cast<long>(std::floor(axis.high / step + 1e-9));
  for (long i = first; i <= last; ++i) values.push_back(static_cast<double>(i) * step);
  return values;
}

std::string place(double x, double y) { return fmt::format("{} {}", decimal(x, 1), decimal(y, 1)); }

}  // namespace

void Axis::include(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void Axis::include(const VectorXd& values) {
  for (const double value : values) include(value);
}

Axis Axis::roomy(double share) const {
  if (!(high > low)) return {title, low, low + 1.0};
  return {title, low - share * (high - low), high + share * (high - low)};
}

Axis axis_of(std::string title, const VectorXd& values) {
  const auto is_number = [](double value) { return std::isfinite(value); };
  const auto first = std::find_if(values.begin(), values.end(), is_number);
  const double begin = first == values.end() ? 0.0 : *first;
  Axis axis{std::move(title), begin, begin};
  axis.include(values);
  return axis;
}

Chart::Chart(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)) {
  for (const double value : ticks(x_)) {
    drawn_ += svg_line("grid", {at_x(value), kTop}, {at_x(value), kBottom});
    drawn_ += svg_text("tick middle", {at_x(value), kBottom + 15}, fmt::format("{:.6g}", value));
  }
  for (const double value : ticks(y_)) {
    drawn_ += svg_line(value == 0.0 ? "zero" : "grid", {kLeft, at_y(value)}, {kRight, at_y(value)});
    drawn_ += svg_text("tick end", {kLeft - 5, at_y(value) + 4}, fmt::format("{:.6g}", value));
  }
  drawn_ += svg_text("axis", {2, 14}, y_.title);
  drawn_ += svg_text("axis end", {kRight, kHeight - 5}, x_.title);
}

double Chart::at_x(double value) const {
  return kLeft + (value - x_.low) / (x_.high - x_.low) * (kRight - kLeft);
}

double Chart::at_y(double value) const {
  return kBottom - (value - y_.low) / (y_.high - y_.low) * (kBottom - kTop);
}

std::string Chart::path(const VectorXd& x, const VectorXd& y) const {
  std::string text;
  bool is_on = false;
  for (Index i = 0; i < x.size(); ++i) {
    const bool is_there = std::isfinite(x[i]) && std::isfinite(y[i]);
    if (is_there) text += (is_on ? "L" : "M") + place(at_x(x[i]), at_y(y[i]));
    is_on = is_there;
  }
  return text;
}

void Chart::strip(const std::string& style, double from, double until) {
  const double left = at_x(from);
  drawn_ += svg_rectangle(style, {left, kTop}, {std::max(1.5, at_x(until) - left), kBottom - kTop});
}

void Chart::area(const std::string& style, const VectorXd& x, const VectorXd& upper,
                 const VectorXd& lower) {
  // In pieces: where there is nothing the area is cut.
  for (Index from = 0; from < x.size();) {
    Index until = from;
    while (until < x.size() && std::isfinite(upper[until]) && std::isfinite(lower[until])) ++until;
    if (until > from) {
      std::string outline = path(x.segment(from, until - from), upper.segment(from, until - from));
      for (Index i = until; i-- > from;) outline += "L" + place(at_x(x[i]), at_y(lower[i]));
      drawn_ += fmt::format("<path class=\"{}\" d=\"{}Z\"/>\n", style, outline);
    }
    from = until + 1;
  }
}

void Chart::curve(const std::string& style, const VectorXd& x, const VectorXd& y) {
  const std::string outline = path(x, y);
  if (!outline.empty()) drawn_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, outline);
}

void Chart::level(const std::string& style, double y) {
  drawn_ += svg_line(style, {kLeft, at_y(y)}, {kRight, at_y(y)});
}

void Chart::line(const std::string& style, double from_x, double from_y, double to_x, double to_y) {
  drawn_ += svg_line(style, {at_x(from_x), at_y(from_y)}, {at_x(to_x), at_y(to_y)});
}

void Chart::dot(const std::string& style, double x, double y) {
  drawn_ += svg_circle(style, {at_x(x), at_y(y)}, 2.2);
}

void Chart::label(const std::string& style, double x, double y, const std::string& text) {
  const bool is_right = at_x(x) > (kLeft + kRight) / 2;
  drawn_ += svg_text(style + (is_right ? " end" : ""), {at_x(x) + (is_right ? -6 : 6), at_y(y) - 5},
                     text);
}

void Chart::moving_line(const std::string& x) {
  moving_ += fmt::format("<line class=\"moves cursor\" data-x=\"{}\" y1=\"{}\" y2=\"{}\"/>\n",
                         escaped(x), kTop, kBottom);
}

void Chart::moving_dot(const std::string& x, const std::string& y, const std::string& bad) {
  moving_ += fmt::format(
      "<circle class=\"moves now\" r=\"5\" data-x=\"{}\" data-y=\"{}\" data-bad=\"{}\"/>\n",
      escaped(x), escaped(y), escaped(bad));
}

void Chart::moving_bar(const std::string& x, const std::string& from_y, const std::string& to_y) {
  moving_ +=
      fmt::format("<line class=\"moves span\" data-x=\"{}\" data-y1=\"{}\" data-y2=\"{}\"/>\n",
                  escaped(x), escaped(from_y), escaped(to_y));
}

std::string Chart::svg(const std::string& title) const {
  const double per_x = (kRight - kLeft) / (x_.high - x_.low);
  const double per_y = (kBottom - kTop) / (y_.high - y_.low);
  // The script's scales: a value times the slope plus the place of zero.
  return fmt::format(
      "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 {} {}\" data-x-slope=\"{:.8g}\" "
      "data-x-zero=\"{:.8g}\" data-y-slope=\"{:.8g}\" data-y-zero=\"{:.8g}\">\n"
      "<title>{}</title>\n{}{}</svg>\n",
      kWidth, kHeight, per_x, kLeft - per_x * x_.low, -per_y, kBottom + per_y * y_.low,
      escaped(title), drawn_, moving_);
}

}  // namespace torquewright::report
