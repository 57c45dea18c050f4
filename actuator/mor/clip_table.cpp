// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/clip_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace torquewright::actuator {
namespace {

constexpr double kCellRounding = 1e-6;  // of a cell: above any rounding, below any row that matters
constexpr std::size_t kCellsPerRow = 32;  // so that a cell seldom holds the start of a row

/// The union of what stands on both sides of rest: what the contract asks of a sample at speed 0.
Interval at_rest(const ClipPoints& points, const TableView& table) {
  const std::vector<double>& speeds_rad_s = points.speeds_rad_s;
  const auto [first, end] = std::equal_range(speeds_rad_s.begin(), speeds_rad_s.end(), 0.0);
  if (first == end) {  // no point at rest: between two, or beyond all of them
    constexpr double kNearlyRest = 1e-300;
    return torquewright_table_limits(&table, kNearlyRest);
  }
  const auto begin = first - speeds_rad_s.begin();
  const auto count = end - first;
  const auto least = points.least_Nm.begin() + begin;
  const auto greatest = points.greatest_Nm.begin() + begin;
  return {*std::min_element(least, least + count), *std::max_element(greatest, greatest + count)};
}

}  // namespace

ClipPoints clip_points(const MorTable& table) {
  ClipPoints points;
  for (const MorRow& row : table.rows) {
    if (row.range.is_empty) continue;
    points.speeds_rad_s.push_back(row.speed_rad_s);
    points.least_Nm.push_back(row.range.least.torque_Nm);
    points.greatest_Nm.push_back(row.range.greatest.torque_Nm);
  }
  return points;
}

ClipPoints drawn_in(ClipPoints points, double by_Nm) {
  for (std::size_t i = 0; i < points.least_Nm.size(); ++i) {
    const double middle_Nm = 0.5 * (points.least_Nm[i] + points.greatest_Nm[i]);
    points.least_Nm[i] = std::min(points.least_Nm[i] + by_Nm, middle_Nm);
    points.greatest_Nm[i] = std::max(points.greatest_Nm[i] - by_Nm, middle_Nm);
  }
  return points;
}

ClipTable::ClipTable(const ClipPoints& points) {
  const std::vector<double>& speeds_rad_s = points.speeds_rad_s;
  const std::size_t count = speeds_rad_s.size();
  if (count < 2 || !(speeds_rad_s.front() < speeds_rad_s.back())) {
    throw std::invalid_argument("a clip table needs the region at two speeds");
  }
  rows_.resize(count);
  torquewright_make_rows(speeds_rad_s.data(), points.least_Nm.data(), points.greatest_Nm.data(),
                         count, rows_.data());
  rest_ = at_rest(points, {rows_.data(), count, {}, nullptr, 0, 0.0});

  const std::size_t cells = kCellsPerRow * count;
  const double width_rad_s =
      (speeds_rad_s.back() - speeds_rad_s.front()) / static_cast<double>(cells);
  cells_per_rad_s_ = 1.0 / width_rad_s;
  std::size_t row = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    // A little before the cell: rounding may count in a speed from just below its start.
    const double start_rad_s =
        speeds_rad_s.front() + (static_cast<double>(cell) - kCellRounding) * width_rad_s;
    while (rows_[row].next_speed_rad_s <= start_rad_s) ++row;
    first_row_.push_back(static_cast<std::uint32_t>(row));
  }
  first_row_.push_back(static_cast<std::uint32_t>(count - 1));
}

TableView ClipTable::view() const {
  return {rows_.data(),      rows_.size(),          rest_,
          first_row_.data(), first_row_.size() - 1, cells_per_rad_s_};
}

}  // namespace torquewright::actuator
