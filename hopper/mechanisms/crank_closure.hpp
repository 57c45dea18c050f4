// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

namespace torquewright::hopper {

/// Where a crank must stand so that its end keeps a distance: the x with A cos x + B sin x = C, on
/// the one side (branch 1) or the other (-1) of the direction (A, B). Empty where there is none,
/// and where crank and rod are in line. docs/derivations/mechanisms.md eq. (6).
inline std::optional<double> closing_angle_rad(double A, double B, double C, int branch) {
  const double greatest = std::hypot(A, B);
  if (!(std::abs(C) < greatest)) return std::nullopt;
  return std::atan2(B, A) + branch * std::acos(C / greatest);
}

}  // namespace torquewright::hopper
