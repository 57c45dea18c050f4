// SPDX-License-Identifier: Apache-2.0
#include "simulation/contact/obstacles.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/passive_forces.hpp"

namespace torquewright::simulation {

using Eigen::Index;

dynamics::BodyPoint lowest_point(const dynamics::TreeState& state, const GroundPoint& point) {
  dynamics::BodyPoint lowest = point.point;
  if (point.radius_m > 0.0) {
    lowest.p_B_m -= point.radius_m * state.motion(lowest.body).R_WB.row(2).transpose();
  }
  return lowest;
}

std::vector<JointStop> joint_stops(const dynamics::Tree& tree) {
  std::vector<JointStop> stops;
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const Index row = tree.base_velocity_size() + static_cast<Index>(i) - 1;
    const dynamics::JointLimits& limits = tree.bodies[i].joint.limits;
    if (std::isfinite(limits.position_min)) stops.push_back({row, limits.position_min, 1.0});
    if (std::isfinite(limits.position_max)) stops.push_back({row, limits.position_max, -1.0});
  }
  return stops;
}

std::vector<JointFriction> joint_frictions(const dynamics::Tree& tree) {
  std::vector<JointFriction> frictions;
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const dynamics::PassiveForces& passive = tree.bodies[i].joint.passive;
    const double resting = dynamics::friction_limit(passive, 0.0);
    if (resting == 0.0) continue;
    const Index row = tree.base_velocity_size() + static_cast<Index>(i) - 1;
    frictions.push_back({row, passive.dry_friction, resting});
  }
  return frictions;
}

}  // namespace torquewright::simulation
