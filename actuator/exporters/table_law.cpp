// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/table_law.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actuator/clip_table.hpp"

namespace torquewright::actuator {
namespace {

std::string array(std::string_view name, std::span<const double> values) {
  constexpr int kPerLine = 4;
  std::string text = fmt::format("  static constexpr double {}[] = {{", name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += i % kPerLine == 0 ? "\n      " : " ";
    text += fmt::format("{},", values[i]);
  }
  return text + "};\n";
}

}  // namespace

Shape table_shape(const Subject& subject) {
  const ClipTable table(subject.table);
  const double inset_Nm =
      subject.fit == Fit::kConservative ? subject.table.interpolation_error_Nm : 0.0;
  Shape shape = table.speeds_rad_s();
  const std::size_t rows = shape.size();
  for (std::size_t i = 0; i < rows; ++i) {
    shape.push_back(std::min(table.least_Nm()[i] + inset_Nm,
                             0.5 * (table.least_Nm()[i] + table.greatest_Nm()[i])));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    shape.push_back(std::max(table.greatest_Nm()[i] - inset_Nm,
                             0.5 * (table.least_Nm()[i] + table.greatest_Nm()[i])));
  }
  return shape;
}

TorqueLimits table_law(std::span<const double> shape, double speed_rad_s) {
  const std::size_t rows = shape.size() / 3;
  TableView table{shape.data(), shape.data() + rows, shape.data() + 2 * rows, rows, {}, nullptr, 0,
                  0.0};
  if (speed_rad_s == 0.0) {
    const auto block = [&](std::size_t i) {
      const std::span<const double> part = shape.subspan(i * rows, rows);
      return std::vector<double>(part.begin(), part.end());
    };
    table.rest = at_rest(block(0), block(1), block(2));
  }
  const Interval interval = limits(table, speed_rad_s);
  return {interval.least_Nm, interval.greatest_Nm};
}

std::string table_function(std::string_view name, std::span<const double> shape) {
  const std::size_t rows = shape.size() / 3;
  const TorqueLimits rest = table_law(shape, 0.0);
  std::string text = fmt::format(R"(/// Least and greatest torque [Nm] at a speed [rad/s].
inline std::pair<double, double> {}(double speed) {{
)",
                                 name);
  text += array("kSpeed", shape.subspan(0, rows));
  text += array("kLeast", shape.subspan(rows, rows));
  text += array("kGreatest", shape.subspan(2 * rows, rows));
  text += fmt::format(R"(  constexpr int kRows = {};
  if (speed == 0.0) return {{{}, {}}};
  const auto row = std::upper_bound(kSpeed, kSpeed + kRows, speed) - kSpeed;
  if (row == 0) return {{kLeast[0], kGreatest[0]}};
  if (row == kRows) return {{kLeast[kRows - 1], kGreatest[kRows - 1]}};
  const double share = (speed - kSpeed[row - 1]) / (kSpeed[row] - kSpeed[row - 1]);
  return {{kLeast[row - 1] + share * (kLeast[row] - kLeast[row - 1]),
          kGreatest[row - 1] + share * (kGreatest[row] - kGreatest[row - 1])}};
}}
)",
                      rows, rest.least_Nm, rest.greatest_Nm);
  return text;
}

}  // namespace torquewright::actuator
