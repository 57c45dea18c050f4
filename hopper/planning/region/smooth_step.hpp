// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/region/smooth_surface.hpp"

namespace torquewright::hopper {

/// A step from 0 to 1 between two speeds, twice continuously differentiable.
struct SmoothStep {
  double from_rad_s = 0.0;
  double to_rad_s = 0.0;

  Taylor at(double speed_rad_s) const;

  /// One curve before the step, the other after it, in between from one to the other.
  Taylor between(const SmoothCurve& before, const SmoothCurve& after, double speed_rad_s) const;
};

}  // namespace torquewright::hopper
