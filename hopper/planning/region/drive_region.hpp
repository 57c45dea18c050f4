// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "hopper/planning/region/drive_power.hpp"
#include "hopper/planning/region/planned_region.hpp"
#include "hopper/replay/powered_drive_options.hpp"

namespace torquewright::hopper {

struct DriveRegionOptions {
  DriveLimits limits = DriveLimits::kMor;
  double voltage_margin = 0.0;  ///< The region is asked at (1 - it) of the bus voltage.
  double current_margin = 0.0;  ///< Shrinks a bound by this share where current is what limits.
  bool shares_battery = false;  ///< With other drives; hopper/planning/region/held_bus.hpp.
};

/// The torque that a plan may ask of a drive at an instant: rows <= 0 of torque, speed (both at the
/// drive's output) and bus voltage, and the power that it then takes from the bus. Twice
/// continuously differentiable and finite everywhere. Rows and |torque| <= greatest_torque_Nm()
/// together stay inside the region that `hopper check` judges by at that voltage (0.4 to 1.3 of the
/// open circuit's, margin counted); docs/derivations/planned_regions.md says how well.
class DriveRegion {
 public:
  /// Throws io::SpecError, which names the actuator, where the conditions cannot be met or where
  /// the region is empty at rest. Requires margins of at least 0 and below 1.
  DriveRegion(const actuator::Actuator& actuator, const actuator::OperatingConditions& conditions,
              const DriveRegionOptions& options);

  std::size_t rows() const { return straight_.size() + (fitted_ ? fitted_->size() : 0); }

  /// Computes by how much each bound is exceeded, in Nm, before the gear's losses; 0 or less: it is
  /// kept. Requires room for rows().
  template <typename T>
  void rows(const T& torque_Nm, const T& speed_rad_s, const T& bus_V, std::span<T> out) const {
    for (std::size_t i = 0; i < straight_.size(); ++i) {
      const StraightRow& row = straight_[i];
      T value = row.per_rad_s * speed_rad_s + row.constant_Nm;
      if (row.per_Nm != 0.0) value += row.per_Nm * torque_Nm;
      if (row.per_V != 0.0) value += row.per_V * bus_V;
      out[i] = value;
    }
    if (fitted_) fitted_->rows(torque_Nm, speed_rad_s, bus_V, out.subspan(straight_.size()));
  }

  /// Whatever the voltage: where a drive weakens the field, what it does in the conditions, as
  /// `hopper check` counts its power.
  template <typename T>
  T bus_power_W(const T& torque_Nm, const T& speed_rad_s, const T& /*bus_V*/) const {
    return power_->W(torque_Nm, speed_rad_s);
  }

  /// Greatest torque of the region at any speed and voltage, in Nm.
  double greatest_torque_Nm() const { return greatest_torque_Nm_; }
  /// Speed without load at the open circuit's voltage.
  double greatest_speed_rad_s() const { return greatest_speed_rad_s_; }

  /// How far the rows' bounds are inside the true ones at most, margins apart; 0: not at all.
  double greatest_loss_Nm() const { return fitted_ ? fitted_->loss().greatest_Nm : 0.0; }
  /// The same at edges, whose bounds no smooth one follows: within jump_width_rad_s() of a speed
  /// where a true bound jumps (drag and gear losses at rest, the onset of a regeneration limit),
  /// and within PlannedRegion::kNose of the speed at which the region ends.
  double loss_at_edges_Nm() const { return fitted_ ? fitted_->loss().at_edges_Nm : 0.0; }
  double jump_width_rad_s() const { return jump_width_rad_s_; }
  bool is_near_jump(double speed_rad_s) const {
    return fitted_ && fitted_->is_near_jump(speed_rad_s);
  }

 private:
  struct StraightRow {
    double per_Nm = 0.0;
    double per_rad_s = 0.0;
    double per_V = 0.0;
    double constant_Nm = 0.0;
  };

  void be_box(const actuator::JointRange& rest, const DriveRegionOptions& options);
  void be_region(const HeldBus& bus, const DriveRegionOptions& options);
  /// Makes the rows of a drive that is known by its curve.
  void be_envelope(const HeldBus& bus, const DriveRegionOptions& options);

  std::vector<StraightRow> straight_;
  std::shared_ptr<const PlannedRegion> fitted_;  ///< Null: the straight rows are all there is.
  std::shared_ptr<const DrivePower> power_;
  double greatest_torque_Nm_ = 0.0;
  double greatest_speed_rad_s_ = 0.0;
  double jump_width_rad_s_ = 0.0;
};

}  // namespace torquewright::hopper
