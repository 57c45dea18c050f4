// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/table_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/mor/clip_table.hpp"

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
  const double inset_Nm =
      subject.fit == LawFit::kConservative ? subject.table.interpolation_error_Nm : 0.0;
  const ClipPoints points = drawn_in(clip_points(subject.table), inset_Nm);
  Shape shape = points.speeds_rad_s;
  shape.insert(shape.end(), points.least_Nm.begin(), points.least_Nm.end());
  shape.insert(shape.end(), points.greatest_Nm.begin(), points.greatest_Nm.end());
  return shape;
}

TorqueLimits table_law(std::span<const double> shape, double speed_rad_s) {
  const std::size_t rows = shape.size() / 3;
  const auto speeds_rad_s = shape.subspan(0, rows);
  const auto least_Nm = shape.subspan(rows, rows);
  const auto greatest_Nm = shape.subspan(2 * rows, rows);
  // Points before the speed, and points up to and with it.
  const auto place = [&](auto end) { return static_cast<std::size_t>(end - speeds_rad_s.begin()); };
  const std::size_t before =
      place(std::lower_bound(speeds_rad_s.begin(), speeds_rad_s.end(), speed_rad_s));
  const std::size_t through =
      place(std::upper_bound(speeds_rad_s.begin(), speeds_rad_s.end(), speed_rad_s));
  if (before < through) {  // at a point; at a jump the union of both sides
    TorqueLimits limits{least_Nm[before], greatest_Nm[before]};
    for (std::size_t i = before + 1; i < through; ++i) {
      limits.least_Nm = std::min(limits.least_Nm, least_Nm[i]);
      limits.greatest_Nm = std::max(limits.greatest_Nm, greatest_Nm[i]);
    }
    return limits;
  }
  if (before == 0) return {least_Nm.front(), greatest_Nm.front()};
  if (before == rows) return {least_Nm.back(), greatest_Nm.back()};
  const double share =
      (speed_rad_s - speeds_rad_s[before - 1]) / (speeds_rad_s[before] - speeds_rad_s[before - 1]);
  return {std::lerp(least_Nm[before - 1], least_Nm[before], share),
          std::lerp(greatest_Nm[before - 1], greatest_Nm[before], share)};
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
