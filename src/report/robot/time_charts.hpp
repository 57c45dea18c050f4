// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/check/series.hpp"
#include "src/report/parts/chart.hpp"
#include "src/report/robot/shown_violations.hpp"

namespace torquewright::report {

/// Parts of charts over the time of a series that has a column time_s. Headers name its columns,
/// which must be there.

constexpr double kChartRoom = 0.06;  ///< Of an axis, at either end.

const Eigen::VectorXd& column(const hopper::Series& series, const std::string& header);
Axis time_axis(const hopper::Series& series);

/// The samples that a chart needs of a curve: nothing of its extent is lost.
std::vector<Eigen::Index> drawn_samples(const Eigen::VectorXd& values);
/// The same of a path in the plane, or of two curves at once.
std::vector<Eigen::Index> drawn_samples(const Eigen::VectorXd& one, const Eigen::VectorXd& other);

/// A column as a curve of that class.
struct DrawnColumn {
  std::string style;
  std::string header;
};
void draw_curve(const hopper::Series& series, Chart& chart, const DrawnColumn& drawn);
/// The stretches in which that rule is violated.
void draw_violations(const std::vector<ShownViolation>& violations, Chart& chart,
                     const std::string& name, std::string_view rule);
/// The cursor, and a dot on each of these columns; `bad` may be empty.
void draw_cursor(Chart& chart, const std::vector<std::string>& headers, const std::string& bad);

/// Columns on one axis with its title, over instants that are marked as impacts.
std::string time_chart(const hopper::Series& series, const std::string& heading,
                       const std::string& axis, const std::vector<DrawnColumn>& drawn,
                       const std::vector<double>& impacts_s);

}  // namespace torquewright::report
