// SPDX-License-Identifier: Apache-2.0
#include "hopper/surroundings/push.hpp"

#include "dynamics/point.hpp"

namespace torquewright::hopper {

void add_push(const dynamics::TreeState& state, const Push& push, double step_s,
              dynamics::VectorOut force) {
  const dynamics::RigidInertia& inertia = state.tree().bodies[push.body].inertia;
  const Eigen::Vector3d force_N = push.impulse_N_s / step_s;
  dynamics::add_point_force(state, {push.body, inertia.center_of_mass_m}, force_N, force);
}

}  // namespace torquewright::hopper
