// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/passive_forces.md.
#include "dynamics/passive_forces.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/jet_functions.hpp"

namespace torquewright::dynamics {
namespace {

/// The way in which a joint moves or begins to: -1 or 1; 0: it rests.
double direction_of(double speed, double acceleration) {
  if (std::abs(speed) > kRest) return std::copysign(1.0, speed);
  if (std::abs(acceleration) > kRest) return std::copysign(1.0, acceleration);
  return 0.0;
}

}  // namespace

// eq. (1)
template <typename T>
void add_dampers_and_springs(const TreeStateOf<T>& state, VectorOutOf<T> force) {
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const PassiveForces& passive = bodies[i].joint.passive;
    if (passive.damping == 0 && passive.stiffness == 0) continue;
    const T stretch = state.joint_position(i) - passive.rest_position;
    force[state.joint_row(i)] +=
        passive.damping * state.joint_velocity(i) + passive.stiffness * stretch;
  }
}

// eq. (4)
template <typename T>
void add_smooth_friction(const TreeStateOf<T>& state, double width, VectorOutOf<T> force) {
  using std::sqrt;
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const double friction = bodies[i].joint.passive.dry_friction;
    if (friction == 0) continue;
    const T& speed = state.joint_velocity(i);
    force[state.joint_row(i)] += friction * speed / sqrt(speed * speed + width * width);
  }
}

void add_dry_friction(const TreeState& state, const VectorIn& acceleration, VectorOut force) {
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Eigen::Index row = state.joint_row(i);
    force[row] += bodies[i].joint.passive.dry_friction *
                  direction_of(state.joint_velocity(i), acceleration[row]);
  }
}

void held_by_friction(const TreeState& state, const VectorIn& acceleration, const VectorIn& needed,
                      VectorOut held) {
  held.setZero();
  const std::vector<Body>& bodies = state.tree().bodies;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Eigen::Index row = state.joint_row(i);
    if (direction_of(state.joint_velocity(i), acceleration[row]) != 0.0) continue;
    const double most = friction_limit(bodies[i].joint.passive, 0.0);
    held[row] = std::clamp(needed[row], -most, most);
  }
}

double friction_limit(const PassiveForces& passive, double speed) {
  return std::abs(speed) > kRest ? passive.dry_friction
                                 : std::max(passive.dry_friction, passive.static_friction);
}

template void add_dampers_and_springs(const TreeState&, VectorOut);
template void add_dampers_and_springs(const TreeStateOf<Jet>&, VectorOutOf<Jet>);
template void add_dampers_and_springs(const TreeStateOf<Jet2>&, VectorOutOf<Jet2>);
template void add_smooth_friction(const TreeState&, double, VectorOut);
template void add_smooth_friction(const TreeStateOf<Jet>&, double, VectorOutOf<Jet>);
template void add_smooth_friction(const TreeStateOf<Jet2>&, double, VectorOutOf<Jet2>);

}  // namespace torquewright::dynamics
