// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "actuator/region/operating_conditions.hpp"
#include "dynamics/jet.hpp"
#include "hopper/replay/powered_drive_options.hpp"

namespace torquewright::hopper {

struct DriveRegionOptions {
  DriveLimits limits = DriveLimits::kMor;
  double voltage_margin = 0.0;  ///< The region is asked at (1 - it) of the bus voltage.
  double current_margin = 0.0;  ///< Shrinks a bound by this share where current is what limits.
  bool shares_battery = false;  ///< With other drives; hopper/flip/held_bus.hpp.
};

/// What a plan may ask of a drive at an instant: rows <= 0 of torque, speed (both at the drive's
/// output) and bus voltage, and the power that it then takes from the bus. Twice continuously
/// differentiable everywhere. The rows and |torque| <= greatest_torque_Nm() together stay inside
/// the region of the actuator at that voltage. docs/derivations/planned_regions.md.
class DriveRegion {
 public:
  /// Throws io::SpecError, which names the actuator, where the conditions cannot be met or where
  /// the region is empty at rest. Requires margins of at least 0 and below 1.
  DriveRegion(const actuator::Actuator& actuator, const actuator::OperatingConditions& conditions,
              const DriveRegionOptions& options);

  std::size_t rows() const { return rows_.size(); }

  /// In Nm before the gear's losses; requires room for rows().
  template <typename T>
  void rows(const T& torque_Nm, const T& speed_rad_s, const T& bus_V, std::span<T> out) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Row& row = rows_[i];
      out[i] = row.per_Nm * torque_Nm;
      if (row.per_rad_s != 0.0) out[i] += row.per_rad_s * speed_rad_s;
      if (row.per_V != 0.0) out[i] += row.per_V * bus_V;
      out[i] += row.constant;
    }
  }

  template <typename T>
  T bus_power_W(const T& torque_Nm, const T& speed_rad_s, const T& /*bus_V*/) const {
    return torque_Nm * speed_rad_s + copper_W_Nm2_ * (torque_Nm * torque_Nm);
  }

  double greatest_torque_Nm() const { return greatest_torque_Nm_; }
  /// Without load at the open circuit's voltage.
  double greatest_speed_rad_s() const { return greatest_speed_rad_s_; }

 private:
  struct Row {
    double per_Nm = 0.0;
    double per_rad_s = 0.0;
    double per_V = 0.0;
    double constant = 0.0;
  };

  std::vector<Row> rows_;
  double copper_W_Nm2_ = 0.0;
  double greatest_torque_Nm_ = 0.0;
  double greatest_speed_rad_s_ = 0.0;
};

}  // namespace torquewright::hopper
