// SPDX-License-Identifier: Apache-2.0
#include "actuator/clip_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace torquewright::actuator {
namespace {

constexpr std::size_t kCellsPerRow = 8;  // a cell then seldom holds more than one row

}  // namespace

Interval at_rest(const std::vector<double>& speeds_rad_s, const std::vector<double>& least_Nm,
                 const std::vector<double>& greatest_Nm) {
  const TableView whole{speeds_rad_s.data(),
                        least_Nm.data(),
                        greatest_Nm.data(),
                        speeds_rad_s.size(),
                        {},
                        nullptr,
                        0,
                        0.0};
  const auto [first, end] = std::equal_range(speeds_rad_s.begin(), speeds_rad_s.end(), 0.0);
  if (first == end) {  // no row at rest: between two rows, or beyond all of them
    constexpr double kNearlyRest = 1e-300;
    return torquewright_table_limits(&whole, kNearlyRest);
  }
  const auto begin = first - speeds_rad_s.begin();
  const auto count = end - first;
  return {*std::min_element(least_Nm.begin() + begin, least_Nm.begin() + begin + count),
          *std::max_element(greatest_Nm.begin() + begin, greatest_Nm.begin() + begin + count)};
}

ClipTable::ClipTable(const MorTable& table) {
  for (const MorRow& row : table.rows) {
    if (row.range.is_empty) continue;
    speeds_rad_s_.push_back(row.speed_rad_s);
    least_Nm_.push_back(row.range.least.torque_Nm);
    greatest_Nm_.push_back(row.range.greatest.torque_Nm);
  }
  const std::size_t rows = speeds_rad_s_.size();
  if (rows < 2 || !(speeds_rad_s_.front() < speeds_rad_s_.back())) {
    throw std::invalid_argument("a clip table needs the region at two speeds");
  }
  const std::size_t cells = kCellsPerRow * rows;
  const double width_rad_s =
      (speeds_rad_s_.back() - speeds_rad_s_.front()) / static_cast<double>(cells);
  cells_per_rad_s_ = 1.0 / width_rad_s;
  std::size_t row = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double start_rad_s = speeds_rad_s_.front() + static_cast<double>(cell) * width_rad_s;
    while (row + 2 < rows && speeds_rad_s_[row + 1] <= start_rad_s) ++row;
    first_row_.push_back(static_cast<std::uint32_t>(row));
  }
}

TableView ClipTable::view() const {
  return {speeds_rad_s_.data(),
          least_Nm_.data(),
          greatest_Nm_.data(),
          speeds_rad_s_.size(),
          at_rest(speeds_rad_s_, least_Nm_, greatest_Nm_),
          first_row_.data(),
          first_row_.size(),
          cells_per_rad_s_};
}

}  // namespace torquewright::actuator
