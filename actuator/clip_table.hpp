// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "actuator/clip.hpp"
#include "actuator/mor_table.hpp"

namespace torquewright::actuator {

/// Owns the arrays that a torquewright_table points into: ascending speeds and the index over them.
/// Rows where the region is empty are left out, so that beside such a gap the nearest bounds that
/// exist are held or joined.
class ClipTable {
 public:
  /// Requires at least two rows that are not empty.
  explicit ClipTable(const MorTable& table);

  /// Holds as long as this object lives where it is.
  TableView view() const;

  const std::vector<double>& speeds_rad_s() const { return speeds_rad_s_; }
  const std::vector<double>& least_Nm() const { return least_Nm_; }
  const std::vector<double>& greatest_Nm() const { return greatest_Nm_; }

 private:
  std::vector<double> speeds_rad_s_;
  std::vector<double> least_Nm_;
  std::vector<double> greatest_Nm_;
  std::vector<std::uint32_t> first_row_;
  double cells_per_rad_s_ = 0.0;
};

/// The union of what stands on both sides of rest: what the contract asks of a sample at speed 0.
/// Requires rows of ascending speed.
Interval at_rest(const std::vector<double>& speeds_rad_s, const std::vector<double>& least_Nm,
                 const std::vector<double>& greatest_Nm);

}  // namespace torquewright::actuator
