// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/conditions/region_grid.hpp"

namespace torquewright::actuator {

/// What an actuator can do at its joint while something else sets the voltage of its bus, and
/// its losses its winding's temperature: by the grid that exporters write, and by the region itself
/// where the grid does not tell. Answers depend on
/// nothing that was asked before; one object serves any number of threads.
class HeldRegion {
 public:
  static constexpr double kColder_K = 100.0;  ///< Than in the conditions: the coldest winding,
  static constexpr double kHotter_K = 400.0;  ///< and the hottest, or where its laws end.
  /// Cells of the grid that are off by more than this part of the peak torque are not used.
  static constexpr double kMostError = 5e-3;
  /// What the grid states of its error is found between its conditions and places; elsewhere it may
  /// be that many times as great, and this part of the peak torque more.
  static constexpr double kErrorOverFound = 1.5;
  static constexpr double kErrorOfPlaces = 1e-3;

  /// The grid is made around the conditions. A battery's resistance and limits are those of the
  /// bus, not of the drive; a `voltage_sag` stays the drive's (without_voltage_sag()). Requires
  /// that there are no objections to the conditions.
  HeldRegion(const Actuator& actuator, const OperatingConditions& conditions,
             GridTemperatures temperatures);

  /// Returns the torques between which the drive is held. Without voltage there is no torque;
  /// beyond the last speed that of the end holds.
  Interval limits(double bus_V, double winding_K, double speed_rad_s) const;

  /// Returns the grid's bounds where they are within error_Nm() of the region's; else nothing:
  /// beyond the grid, in its bad cells, where a bound may jump and in the last 2 % of the speeds.
  std::optional<Interval> tabulated(double bus_V, double winding_K, double speed_rad_s) const;
  double error_Nm() const { return error_Nm_; }

  /// Returns the region itself.
  JointRange exact(double bus_V, double winding_K, double speed_rad_s) const;

  /// Returns the speed beyond which the region is empty, or is looked at no further.
  double greatest_speed_rad_s(double bus_V, double winding_K) const;

  /// Returns the electrical side: constants are linear in the temperature.
  PhaseModel model(double bus_V, double winding_K) const;

  /// Greatest magnitude of a torque in the grid; without one, at rest.
  double peak_torque_Nm() const { return peak_torque_Nm_; }
  /// Whether another actuator's would answer the same.
  bool is_of(const Actuator& actuator, const OperatingConditions& conditions) const;
  /// Null where there is none.
  const RegionGrid* grid() const { return grid_ ? &*grid_ : nullptr; }

 private:
  double known_K(double winding_K) const;
  OperatingConditions at(double bus_V, double winding_K) const;
  std::optional<GridCell> cell(double bus_V, double winding_K) const;

  Actuator on_bus_;
  OperatingConditions conditions_;  ///< The battery's voltage as the bus's.
  double coldest_K_;
  double hottest_K_;
  PhaseModel coldest_;
  PhaseModel hottest_;
  std::optional<RegionGrid> grid_;
  double peak_torque_Nm_ = 0.0;
  double error_Nm_ = 0.0;
};

/// Returns the actuator without what stands for the cables of its battery, whose fall the bus's
/// voltage has already.
Actuator without_voltage_sag(Actuator actuator);

}  // namespace torquewright::actuator
