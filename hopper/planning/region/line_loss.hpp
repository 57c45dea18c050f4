// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/region/smooth_surface.hpp"

namespace torquewright::hopper {

/// V / V_i of a drive behind a line of its own, of x = 4 R_i P_i / V^2: whole_body_check.md's law
/// of a voltage_sag on a shared battery, by its larger root. Beyond x = 0.9, where a third of the
/// voltage is lost, it goes on as a parabola: finite and twice continuously differentiable.
Taylor line_factor(double x);

/// What flows out of the battery at that voltage where a drive takes the power behind its line.
template <typename T>
T drawn_behind_line_W(const T& battery_V, double line_ohm, const T& power_W) {
  if (line_ohm == 0.0) return power_W;
  const T x = power_W * (4.0 * line_ohm) / (battery_V * battery_V);
  return power_W * carried(line_factor(dynamics::value_of(x)), x);
}

}  // namespace torquewright::hopper
