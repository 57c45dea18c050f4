// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/composite.hpp"

#include "dynamics/jet.hpp"

namespace torquewright::dynamics {

template <typename T>
void gather_composites(TreeStateOf<T>& state) {
  const std::vector<Body>& bodies = state.tree().bodies;
  std::vector<typename TreeStateOf<T>::Composite>& composites = state.composites();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const RigidInertia& inertia = bodies[i].inertia;
    const Matrix3<T>& R = state.motion(i).R_WB;
    const Vector3<T>& c = state.motion(i).center_of_mass_m;
    composites[i].mass_kg = inertia.mass_kg;
    composites[i].first_moment_kg_m = inertia.mass_kg * c;
    composites[i].inertia_kg_m2.noalias() = R * inertia.inertia_kg_m2 * R.transpose();
    composites[i].inertia_kg_m2 -= inertia.mass_kg * c * c.transpose();
    composites[i].inertia_kg_m2.diagonal().array() += inertia.mass_kg * c.squaredNorm();
  }
  for (std::size_t i = bodies.size() - 1; i > 0; --i) {
    typename TreeStateOf<T>::Composite& parent = composites[bodies[i].parent];
    parent.mass_kg += composites[i].mass_kg;
    parent.first_moment_kg_m += composites[i].first_moment_kg_m;
    parent.inertia_kg_m2 += composites[i].inertia_kg_m2;
  }
}

template void gather_composites(TreeState&);
template void gather_composites(TreeStateOf<Jet>&);
template void gather_composites(TreeStateOf<Jet2>&);

}  // namespace torquewright::dynamics
