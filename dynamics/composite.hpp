// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/columns.hpp"

namespace torquewright::dynamics {

/// Linear and angular momentum about the base's origin.
template <typename T>
struct MomentumOf {
  Vector3<T> angular_Nm_s;
  Vector3<T> linear_N_s;
};

/// Fills state.composites(): each body joined with all bodies that hang on it; eq. (10).
template <typename T>
void gather_composites(TreeStateOf<T>& state);

/// Returns the momentum of a composite body that moves as the column says; eq. (11).
template <typename T>
inline MomentumOf<T> momentum_of(const typename TreeStateOf<T>::Composite& composite,
                                 const ColumnOf<T>& column) {
  const Vector3<T>& h = composite.first_moment_kg_m;
  return {composite.inertia_kg_m2 * column.angular + h.cross(column.linear),
          composite.mass_kg * column.linear + column.angular.cross(h)};
}

}  // namespace torquewright::dynamics
