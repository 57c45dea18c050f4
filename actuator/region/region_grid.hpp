// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/clip.hpp"
#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// One bound of a region at several supplies and temperatures. Its corners are the speeds where
/// what limits it changes, its sign, rest from either side, and both ends. A place between corners
/// is a number: 2.25 is a quarter of the way from corner 2 to corner 3, wherever the condition puts
/// those. docs/derivations/motor_region.md section 7.
struct GridBound {
  std::vector<double> places;  ///< Ascending, among them every whole number up to the last corner.
  std::vector<std::vector<double>> corners_rad_s;  ///< Of each condition, ascending.
  std::vector<std::vector<double>> torques_Nm;     ///< Of each condition, at every place.
};

/// A region over supply voltage (without load) and winding temperature: between conditions both the
/// corners and the torques at a place are linear in either.
struct RegionGrid {
  std::vector<double> voltages_V;      ///< Ascending.
  std::vector<double> temperatures_K;  ///< Ascending; a condition's number is
                                       ///< voltage * temperatures + temperature.
  GridBound least;
  GridBound greatest;
  /// Share of the greatest speed up to which the grid reaches: past it a region may end in a point
  /// where its bounds stand upright.
  static constexpr double kBeforeEnd = 0.98;
  double error_before_end_Nm = 0.0;  ///< Greatest found between its conditions, up to there.
  double error_Nm = 0.0;             ///< And over all speeds.
  double error_speed_rad_s = 0.0;    ///< Where.
};

/// Around the conditions: from half to 1.2 times the supply's voltage, from freezing to the
/// winding's limit (or 393.15 K), less where the region would have other corners than it has at the
/// conditions. Nothing where the region has a gap.
std::optional<RegionGrid> region_grid(const Actuator& actuator,
                                      const OperatingConditions& conditions, Side side);

/// Bounds of the torque between the grid's conditions, straight in each. Conditions beyond the grid
/// and speeds beyond its ends count as those at the edge. At rest: the union of both directions.
Interval limits(const RegionGrid& grid, double speed_rad_s, double voltage_V, double temperature_K);

}  // namespace torquewright::actuator
