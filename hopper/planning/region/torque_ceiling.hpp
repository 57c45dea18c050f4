// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hopper/planning/region/held_bus.hpp"
#include "hopper/planning/region/smooth_surface.hpp"

namespace torquewright::hopper {

/// One limiter's part of a motor's greatest torque over speed and bus voltage: smooth, and above
/// the others' where it does not limit.
class CeilingPiece {
 public:
  /// `surface`: over the share of the stretch of speeds in which it limits (0 where that begins, 1
  /// where it ends), and over the voltage; begin and logarithm of its length over the voltage.
  CeilingPiece(SmoothSurface surface, SmoothCurve begin_rad_s, SmoothCurve log_length);

  Taylor at(double speed_rad_s, double bus_V) const;

 private:
  SmoothSurface surface_;
  SmoothCurve begin_rad_s_;
  SmoothCurve log_length_;
};

/// The greatest torque of a motor over speed and bus voltage, at the output but before the gear's
/// losses: never above the true one, the least of several pieces. The least torque is its mirror
/// image: - ceiling(-speed).
struct TorqueCeiling {
  double cap_Nm = 0.0;  ///< Greatest torque by current, at any speed.
  std::vector<CeilingPiece> pieces;
  double end_rad_s = 0.0;           ///< As far as it is known, either way.
  bool goes_on = false;             ///< Beyond that.
  std::vector<double> jumps_rad_s;  ///< Where the true one jumps.
};

/// `step_rad_s`: over how much speed what jumps is led up to its jump.
/// docs/derivations/planned_regions.md eq. (3) to (5).
TorqueCeiling torque_ceiling(const HeldBus& bus, double step_rad_s);

}  // namespace torquewright::hopper
