// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "actuator/region/clip_table.hpp"
#include "actuator/region/operating_conditions.hpp"

namespace torquewright::hopper {

/// What an actuator can do while the voltage of its bus and its winding's temperature move: asked
/// at every step of a simulation. Its region's tables (actuator/clip.hpp) are made at levels of
/// both when they are first needed, and bounds are straight between levels. Neither a table nor an
/// answer depends on who asked before; one object serves any number of threads.
///
/// Where a bound has a corner over the voltage (full current gives way to the voltage), straight is
/// off by at most a quarter of a level, towards less torque: what the check's levels, rounded down,
/// may be off everywhere (actuator::BusLevels). docs/derivations/replay_drives.md eq. (3).
class RegionLevels {
 public:
  /// Voltages a level apart are this part of the document's own open circuit apart. Up to twice
  /// that there are levels; beyond, and beyond the last temperatures, the last one holds.
  static constexpr int kLevelsPerOpenCircuit = 250;
  static constexpr double kStep_K = 5.0;
  static constexpr double kColder_K = 100.0;  ///< Than the document's winding: levels begin there,
  static constexpr double kHotter_K = 400.0;  ///< and end here, or where its laws end.

  /// Requires that the document's own conditions have no objections at that rating.
  RegionLevels(const actuator::Actuator& actuator, actuator::Rating rating);
  ~RegionLevels();
  RegionLevels(const RegionLevels&) = delete;
  RegionLevels& operator=(const RegionLevels&) = delete;

  /// Whether they are that actuator's too: so that drives of one kind need no levels each.
  bool are_of(const actuator::Actuator& actuator, actuator::Rating rating) const;

  /// Returns the limits at the joint with the bus held at that voltage. Without voltage there is no
  /// torque.
  actuator::Interval limits(double bus_V, double winding_K, double speed_rad_s) const;

  /// The electrical side, the bus held at that voltage: constants are linear in the temperature.
  actuator::PhaseModel model(double bus_V, double winding_K) const;

 private:
  using Table = std::atomic<const actuator::ClipTable*>;

  actuator::TableView at(int voltage, int temperature) const;
  actuator::Interval over_temperature(int voltage, double temperature, double speed_rad_s) const;
  actuator::ClipTable made(int voltage, int temperature) const;
  double temperature_K(int temperature) const;
  double temperature_level(double winding_K) const;

  actuator::Actuator actuator_;
  actuator::Rating rating_;
  double step_V_;
  double first_K_ = 0.0;
  std::vector<actuator::PhaseModel> models_;  ///< Models by temperature.
  /// Tables by voltage, then by temperature; null: not made yet.
  mutable std::vector<Table> tables_;
  mutable std::mutex growing_;
  mutable std::vector<std::unique_ptr<const actuator::ClipTable>> made_;
};

}  // namespace torquewright::hopper
