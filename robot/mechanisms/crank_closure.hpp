// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "dynamics/jet_functions.hpp"

namespace torquewright::hopper {

/// Where a crank must stand so that its end keeps a distance: the x with A cos x + B sin x = C, on
/// the one side (branch 1) or the other (-1) of the direction (A, B). Empty where there is none,
/// and where crank and rod are in line. docs/derivations/mechanisms.md eq. (6).
template <typename T>
std::optional<T> closing_angle_rad(const T& A, const T& B, const T& C, int branch) {
  using std::abs, std::acos, std::atan2, std::hypot;
  const T greatest = hypot(A, B);
  if (!(abs(C) < greatest)) return std::nullopt;
  return atan2(B, A) + branch * acos(C / greatest);
}

}  // namespace torquewright::hopper
