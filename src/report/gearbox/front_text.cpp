// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/front_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gearbox/any_topology.hpp"
#include "gearbox/front/front_spec.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

using namespace gearbox;

/// With the topology where the problem leaves it open.
std::string teeth_of(const Problem& problem, const FrontPoint& point) {
  const Design& design = point.report.design;
  std::string text =
      fmt::format("{}{} n {} m {:g}", is_topology_open(problem) ? point.problem.topology + " " : "",
                  fmt::join(design.teeth, "/"), design.planet_count, io::nearest(design.module_mm));
  if (design.layer_2_module_mm) {
    text += fmt::format(" and {:g}", io::nearest(*design.layer_2_module_mm));
  }
  return text;
}

/// Paper and what it shows.
class Plot {
 public:
  explicit Plot(const std::vector<FrontPoint>& points) {
    for (const FrontPoint& point : points) {
      low_ = {std::min(low_.x, point.second), std::min(low_.y, point.first_bound)};
      high_ = {std::max(high_.x, point.second), std::max(high_.y, point.first)};
      low_.y = std::min(low_.y, point.first);
      high_.y = std::max(high_.y, point.first_bound);
    }
    const auto widen = [](double& low, double& high) {
      const double room = high > low ? 0.08 * (high - low) : 0.5;
      low -= room;
      high += room;
    };
    widen(low_.x, high_.x);
    widen(low_.y, high_.y);
  }

  Point at(double second, double first) const {
    return {kLeft_mm + kWidth_mm * (second - low_.x) / (high_.x - low_.x),
            kTop_mm + kHeight_mm * (high_.y - first) / (high_.y - low_.y)};
  }

  std::string frame(const std::string& title, const std::string& x, const std::string& y) const {
    std::string svg = svg_rectangle("frame", {kLeft_mm, kTop_mm}, {kWidth_mm, kHeight_mm});
    svg += svg_text("title middle", {kLeft_mm + 0.5 * kWidth_mm, 8.0}, title);
    svg += svg_text("middle", {kLeft_mm + 0.5 * kWidth_mm, kTop_mm + kHeight_mm + 12.0}, x);
    svg += svg_text("middle", {6.0, kTop_mm + 0.5 * kHeight_mm}, y, -90.0);
    constexpr int kTicks = 5;
    for (int i = 0; i <= kTicks; ++i) {
      const double share = i / double{kTicks};
      const double second = low_.x + share * (high_.x - low_.x);
      const double first = low_.y + share * (high_.y - low_.y);
      const Point below = at(second, low_.y), left = at(low_.x, first);
      svg += svg_line("rule", below, {below.x, below.y + 1.5});
      svg += svg_text("middle", {below.x, below.y + 5.5}, fmt::format("{:.4g}", second));
      svg += svg_line("rule", {left.x - 1.5, left.y}, left);
      svg += svg_text("end", {left.x - 2.5, left.y + 1.1}, fmt::format("{:.4g}", first));
    }
    return svg;
  }

 private:
  static constexpr double kLeft_mm = 28.0, kTop_mm = 14.0, kWidth_mm = 120.0, kHeight_mm = 80.0;
  Point low_{1e300, 1e300}, high_{-1e300, -1e300};
};

constexpr const char* kOpening =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="160mm" height="112mm" viewBox="0 0 160 112">
<style>text{font-family:sans-serif;font-size:3.2px;fill:#1b2631}.title{font-size:4.2px;font-weight:bold}
.middle{text-anchor:middle}.end{text-anchor:end}.frame{fill:none;stroke:#1b2631;stroke-width:0.3px}
.rule{stroke:#1b2631;stroke-width:0.2px}.front{stroke:#1f618d;stroke-width:0.5px}
.bound{stroke:#a93226;stroke-width:0.2px;stroke-dasharray:1 0.6}.point{fill:#1f618d}</style>
)";

}  // namespace

std::string front_text(const Problem& problem, const gearbox::ShownFront& shown) {
  const Front& front = shown.front;
  if (front.points.empty()) {
    return front.is_whole ? "infeasible: no design satisfies all constraints.\n"
                          : "limit: the search ended before it found a point.\n";
  }
  const std::string_view first = objective_name(shown.first), second = objective_name(shown.second);
  std::string text = fmt::format(
      "{}: {} of the front of {} against {}, each proved.\n",
      front.is_whole ? (problem.synthesis ? "sampled" : "whole") : "limit",
      front.points.size() == 1 ? "1 point" : fmt::format("{} points", front.points.size()), first,
      second);
  text += fmt::format("{:>20} {:>20} {:>20} {:>20}  {}\n", second, "holds from", first, "bound",
                      "design");
  for (const FrontPoint& point : front.points) {
    text += fmt::format("{:>20.6g} {:>20} {:>20.6g} {:>20.6g}  {}\n", point.second,
                        point.from ? fmt::format("{:.6g}", *point.from) : "any", point.first,
                        point.first_bound, teeth_of(problem, point));
  }
  if (front.none_from) {
    text += fmt::format("Proved: no design has a {} of {:.6g} or {}.\n", second, *front.none_from,
                        gearbox::is_greater_better(shown.second) ? "more" : "less");
  }
  if (!problem.assumed.empty()) {
    text += fmt::format("Assumed, neither published nor measured: {}.\n",
                        fmt::join(problem.assumed, ", "));
  }
  return text;
}

std::string front_svg(const Problem& problem, const gearbox::ShownFront& shown) {
  const Plot plot(shown.front.points);
  const auto title = [](Objective objective) {
    return fmt::format("{} [{}]", objective_name(objective), objective_unit(objective));
  };
  std::string svg = kOpening + plot.frame(problem.name, title(shown.second), title(shown.first));
  const FrontPoint* before = nullptr;
  for (const FrontPoint& point : shown.front.points) {
    if (before != nullptr) {
      svg += svg_line("front", plot.at(before->second, before->first),
                      plot.at(before->second, point.first));
      svg += svg_line("front", plot.at(before->second, point.first),
                      plot.at(point.second, point.first));
    }
    const double from = point.from.value_or(point.second);
    svg += svg_line("bound", plot.at(from, point.first_bound),
                    plot.at(point.second, point.first_bound));
    svg += svg_circle("point", plot.at(point.second, point.first), 0.9);
    before = &point;
  }
  return svg + "</svg>\n";
}

}  // namespace torquewright::report
