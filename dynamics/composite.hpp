// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/columns.hpp"

namespace torquewright::dynamics {

/// Momentum about the base's origin.
struct Momentum {
  Eigen::Vector3d angular_Nm_s;
  Eigen::Vector3d linear_N_s;
};

/// Fills state.composites(), each body with all that hangs on it; eq. (10).
void gather_composites(TreeState& state);

/// Of a composite that moves as the column says; eq. (11).
inline Momentum momentum_of(const TreeState::Composite& composite, const Column& column) {
  const Eigen::Vector3d& h = composite.first_moment_kg_m;
  return {composite.inertia_kg_m2 * column.angular + h.cross(column.linear),
          composite.mass_kg * column.linear + column.angular.cross(h)};
}

}  // namespace torquewright::dynamics
