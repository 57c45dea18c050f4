// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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
  std::size_t rest_corner = 0;                     ///< At rest from below; the next is from above.
  /// Corners from which the bound jumps to the next corner, which is as close as rounding allows.
  std::vector<std::size_t> jumps;
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
  double error_before_end_Nm = 0.0;  ///< Greatest found between its conditions, up to there,
  /// Of each cell between its conditions, by voltage, then temperature: up to there, where no bound
  /// may jump (may_jump()).
  std::vector<double> cell_errors_Nm;
  std::vector<double> cell_errors_with_jumps_Nm;  ///< The same wherever a bound jumps too.
  double error_Nm = 0.0;                          ///< And over all speeds.
  double error_speed_rad_s = 0.0;                 ///< Where.
};

/// Over which temperatures of the winding a grid reaches.
enum class GridTemperatures {
  kFreezingToLimit,  ///< From freezing to the winding's limit (or 393.15 K).
  kAsAsked,          ///< That of the conditions alone.
};

/// Between which of its conditions a grid's error is sought.
enum class GridErrors { kAtQuarters, kAtMiddles };

/// Makes the grid around the conditions: from half to 1.2 times the supply's voltage, over the
/// temperatures, less where the region has corners that were found under no condition looked at.
/// Nothing where the region has a gap. A curve has one temperature.
std::optional<RegionGrid> region_grid(
    const Actuator& actuator, const OperatingConditions& conditions, Side side,
    GridTemperatures temperatures = GridTemperatures::kFreezingToLimit,
    GridErrors errors = GridErrors::kAtQuarters);

/// The conditions of a grid between which one lies, and the share of each.
struct GridCell {
  std::size_t cell = 0;        ///< Of RegionGrid::cell_errors_Nm.
  std::size_t conditions = 0;  ///< How many.
  std::array<std::size_t, 4> number;
  std::array<double, 4> weight;
};

/// Whether the grid knows that condition.
bool reaches(const RegionGrid& grid, double voltage_V, double temperature_K);

/// Conditions beyond the grid count as those at its edge.
GridCell cell_at(const RegionGrid& grid, double voltage_V, double temperature_K);

/// The greatest error of the cells about a condition (RegionGrid::cell_errors_with_jumps_Nm).
double error_about_Nm(const RegionGrid& grid, std::size_t condition);

/// Bounds of the torque in the cell, straight between its conditions. Speeds beyond its ends count
/// as those at the ends. At rest: the union of both directions.
Interval limits(const RegionGrid& grid, const GridCell& cell, double speed_rad_s);
Interval limits(const RegionGrid& grid, double speed_rad_s, double voltage_V, double temperature_K);

/// Whether a bound jumps between conditions of the cell at that speed, beside rest: where exactly
/// it does, the grid does not know.
bool may_jump(const RegionGrid& grid, const GridCell& cell, double speed_rad_s);

/// Speed at which the region ends, the lesser of both directions'.
double end_rad_s(const RegionGrid& grid, const GridCell& cell);

}  // namespace torquewright::actuator
