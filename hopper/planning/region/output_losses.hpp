// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/planning/region/held_bus.hpp"
#include "hopper/planning/region/smooth_step.hpp"

namespace torquewright::hopper {

/// Losses of a drive between motor and load on one side of its region: a torque u on the load
/// needs, of the motor and at the output, at most the greater of driven(w) (u - ripple) - help(w)
/// and returned (u - ripple) - help(w), wherever u is near the region's bound. `sign` -1: for the
/// least torque, with u and w negated. docs/derivations/planned_regions.md eq. (6), (7).
struct OutputLosses {
  OutputLosses(const HeldBus& bus, double sign, double end_rad_s, double step_rad_s);

  double ripple_Nm = 0.0;
  double slow_factor = 1.0;  ///< driven(w) at negative speeds,
  double fast_factor = 1.0;  ///< and at others.
  double returned = 1.0;
  SmoothStep step;                       ///< From the one to the other, before rest.
  std::optional<SmoothCurve> help_slow;  ///< Torque of drag and cogging along the torque, at
  std::optional<SmoothCurve> help_fast;  ///< negative speeds and at others; none: zero.
  bool jumps = false;                    ///< At rest.

  Taylor driven(double speed_rad_s) const;
  Taylor help_Nm(double speed_rad_s) const;
};

}  // namespace torquewright::hopper
