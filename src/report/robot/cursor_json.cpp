// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/cursor_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "src/report/parts/page_json.hpp"
#include "src/report/parts/svg.hpp"
#include "src/report/turning/view_json.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;

std::string list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ","));
}

constexpr double kNothing = 1e-9;        // What is smaller is the rounding of a zero,
constexpr double kNothingBeside = 1e-6;  // or what is beside the greatest of its column.

/// Few digits: for the eye, not for arithmetic.
std::string values(const Eigen::VectorXd& column, const std::vector<Index>& samples, int digits) {
  double greatest = 0.0;
  for (const double value : column) {
    if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
  }
  const double nothing = std::max(kNothing, kNothingBeside * greatest);
  std::string text;
  for (const Index sample : samples) {
    const double value = std::abs(column[sample]) < nothing ? 0.0 : column[sample];
    text += text.empty() ? "[" : ",";
    text += std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "null";
  }
  return text + "]";
}

std::string columns(const CursorSource& source) {
  std::vector<std::string> items;
  for (const std::string& header : source.headers) {
    const Eigen::VectorXd* column = hopper::find_column(source.series, header);
    if (column == nullptr) continue;
    items.push_back(json_in_page(header) + ":" +
                    values(*column, source.samples, header == "time_s" ? 8 : 5));
  }
  return fmt::format("{{{}}}", fmt::join(items, ",\n"));
}

std::string intervals(const std::vector<Interval>& times) {
  std::vector<std::string> items;
  for (const Interval& time : times) {
    items.push_back(fmt::format("[{:.8g},{:.8g}]", time.from_s, time.until_s));
  }
  return list(items);
}

std::string violations(const std::vector<ShownViolation>& shown) {
  std::vector<std::string> items;
  for (const ShownViolation& violation : shown) {
    std::string rule = violation.rule;
    std::replace(rule.begin(), rule.end(), '-', ' ');
    items.push_back(fmt::format(
        "{{\"name\":{},\"rule\":{},\"bodies\":[{}],\"worst_s\":{:.8g},\"times\":{}}}",
        json_in_page(violation.name), json_in_page(rule), fmt::join(violation.bodies, ","),
        violation.worst_s, intervals(violation.times)));
  }
  return list(items);
}

std::string drives(const CursorSource& source) {
  std::vector<std::string> items;
  for (const SpokenDrive& drive : source.drives) {
    items.push_back(fmt::format("{{\"name\":{},\"torque\":{},\"speed\":{},\"outside\":{}}}",
                                json_in_page(drive.name), json_in_page(drive.torque),
                                json_in_page(drive.speed), json_in_page(drive.outside)));
  }
  return list(items);
}

template <typename PointOf>
std::string way(const std::vector<Pose>& poses, const PointOf& point_of) {
  std::string x;
  std::string y;
  for (const Pose& pose : poses) {
    const Eigen::Vector2d& point = point_of(pose);
    x += (x.empty() ? "" : ",") + decimal(point.x(), 1);
    y += (y.empty() ? "" : ",") + decimal(point.y(), 1);
  }
  return fmt::format("{{\"x\":[{}],\"y\":[{}]}}", x, y);
}

void add_ways(const Skeleton& skeleton, const std::vector<Pose>& poses,
              std::vector<std::string>& points) {
  for (std::size_t i = 0; i < skeleton.points.size(); ++i) {
    points.push_back(
        way(poses, [i](const Pose& pose) -> const Eigen::Vector2d& { return pose.points[i]; }));
  }
}

std::string figure_keys(const CursorSource& source, const MovingFigure& figure) {
  std::vector<std::string> points;
  add_ways(figure.skeleton, figure.poses, points);
  if (!figure.planned.empty()) add_ways(figure.skeleton, figure.planned, points);
  std::vector<std::string> contacts;
  for (std::size_t i = 0; i < figure.skeleton.contacts.size(); ++i) {
    const bool has_force = i < source.forces.size();
    contacts.push_back(fmt::format("{{\"point\":{},\"x\":{},\"z\":{}}}",
                                   figure.skeleton.contacts[i],
                                   has_force ? json_in_page(source.forces[i].x) : "null",
                                   has_force ? json_in_page(source.forces[i].z) : "null"));
  }
  return fmt::format(
      ",\n\"points\":{},\n\"mass\":{},\n\"contacts\":{},\n\"force\":{{\"greatest_N\":{:.6g},"
      "\"power\":{},\"longest_paper\":{:.6g},\"longest_m\":{:.6g}}}{}",
      fmt::format("[{}]", fmt::join(points, ",\n")),
      way(figure.poses,
          [](const Pose& pose) -> const Eigen::Vector2d& { return pose.center_of_mass_m; }),
      list(contacts), figure.force.greatest_N, figure.force.power(), figure.longest,
      source.longest_m, source.view.empty() ? "" : ",\n\"view\":" + source.view);
}

}  // namespace

void add_view(const hopper::Robot& robot, const TurningView& view, CursorSource& source) {
  source.view = view_json(robot, view);
  source.longest_m = view.longest_m;
  for (const std::vector<ToldValue>& body : view.told) {
    for (const ToldValue& value : body) {
      const auto& known = source.headers;
      if (std::find(known.begin(), known.end(), value.column) != known.end()) continue;
      source.headers.push_back(value.column);
    }
  }
}

std::string cursor_json(const CursorSource& source) {
  return fmt::format(
      "{{\"begin_s\":{:.8g},\n\"columns\":{},\n\"drives\":{},\n\"violations\":{}{}}}",
      source.begin_s, columns(source), drives(source), violations(source.violations),
      source.figure == nullptr ? "" : figure_keys(source, *source.figure));
}

}  // namespace torquewright::report
