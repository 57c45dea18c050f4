// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "actuator/conditions/held_region.hpp"
#include "actuator/mor/mor_table.hpp"

namespace torquewright::actuator {

/// Least and greatest torque of a region at one speed.
struct TorqueRange {
  bool is_empty = false;
  double least_Nm = 0.0;
  double greatest_Nm = 0.0;

  /// Distance of a torque from the nearer bound, in Nm: positive outside, negative inside. Where
  /// the range is empty all of the torque is outside.
  double excess_Nm(double torque_Nm) const;
};

/// Answers questions about a region at the joint, at very many speeds: from a table, and from the
/// region itself where the table might be wrong. Whether a torque is inside or outside is exact.
/// Copies share the table.
class RegionLookup {
 public:
  /// Of the actuator on its own supply.
  RegionLookup(const Actuator& actuator, const OperatingConditions& conditions);
  /// Of an actuator whose bus is held at a voltage.
  RegionLookup(std::shared_ptr<const HeldRegion> held, double bus_V, double winding_K);

  /// Returns the bounds at a speed from the table, which may be off by its accuracy; where it does
  /// not tell (beyond its ends, beside empty ranges) from the region itself.
  TorqueRange near(double speed_rad_s) const;

  /// Returns the same as near(), but from the region itself where the torque lies so near a bound
  /// that the table may be wrong about it.
  TorqueRange at(double speed_rad_s, double torque_Nm) const;

  JointRange exact(double speed_rad_s) const;

  /// Torque past a bound that counts as inside: rounding.
  double round_off_Nm() const { return round_off_Nm_; }
  bool is_outside(const TorqueRange& range, double torque_Nm) const {
    return range.is_empty || range.excess_Nm(torque_Nm) > round_off_Nm_;
  }

  /// Returns how much faster, in its direction, a joint could go with that torque (negative: how
  /// much slower it would have to go), by the table; minus infinity where no speed of that
  /// direction has the torque. A margin of `at_most_rad_s` or more is returned as `at_most_rad_s`,
  /// with less effort.
  double speed_margin_rad_s(double speed_rad_s, double torque_Nm,
                            double at_most_rad_s = kUnlimited) const;

  /// Whether the speed margin is less than `margin_rad_s`; much cheaper than the margin itself.
  bool has_less_speed_margin(double speed_rad_s, double torque_Nm, double margin_rad_s) const;

  double greatest_speed_rad_s() const;
  /// The electrical side.
  const PhaseModel& model() const { return model_; }

 private:
  /// The region on a supply of its own, and its table.
  struct Own {
    Region region;
    MorTable table;
    std::vector<double> speeds_rad_s;  ///< Speeds of the table's rows.
  };

  bool holds(double speed_rad_s, double torque_Nm) const;

  std::shared_ptr<const Own> own_;
  std::shared_ptr<const HeldRegion> held_;  ///< One of the two is null.
  double bus_V_ = 0.0;
  double winding_K_ = 0.0;
  PhaseModel model_;
  double doubt_Nm_;
  double round_off_Nm_;
};

}  // namespace torquewright::actuator
