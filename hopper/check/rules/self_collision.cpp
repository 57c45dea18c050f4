// SPDX-License-Identifier: Apache-2.0
// Spheres of bodies that meet. Bodies that a joint joins overlap there by design and do not count.
#include <fmt/format.h>

#include <limits>

#include "dynamics/point.hpp"
#include "hopper/check/rules/every_rule.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

bool are_joined(const dynamics::Tree& tree, std::size_t one, std::size_t other) {
  const auto carries = [&](std::size_t parent, std::size_t child) {
    return child > 0 && tree.bodies[child].parent == parent;
  };
  return one == other || carries(one, other) || carries(other, one);
}

struct Pair {
  std::size_t one;
  std::size_t other;
  double gap_m = std::numeric_limits<double>::infinity();
  double time_s = 0.0;
};

}  // namespace

std::vector<Finding> self_collision(const CheckedMotion& checked) {
  const std::vector<CollisionSphere>& spheres = checked.robot.spheres;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      if (are_joined(checked.robot.tree, spheres[i].center.body, spheres[j].center.body)) continue;
      pairs.push_back({i, j});
    }
  }
  std::vector<Finding> findings;
  if (pairs.empty()) return findings;
  dynamics::TreeState state(checked.robot.tree);
  for (Eigen::Index sample = 0; sample < checked.motion.samples(); ++sample) {
    state.set(checked.motion.positions.col(sample), checked.motion.velocities.col(sample));
    for (Pair& pair : pairs) {
      const CollisionSphere& one = spheres[pair.one];
      const CollisionSphere& other = spheres[pair.other];
      const double gap_m = (dynamics::point_position_m(state, one.center) -
                            dynamics::point_position_m(state, other.center))
                               .norm() -
                           one.radius_m - other.radius_m;
      if (gap_m >= pair.gap_m) continue;
      pair.gap_m = gap_m;
      pair.time_s = checked.motion.time_s(sample);
    }
  }
  for (const Pair& pair : pairs) {
    if (pair.gap_m >= 0.0) continue;
    const std::string& one = checked.robot.tree.bodies[spheres[pair.one].center.body].name;
    const std::string& other = checked.robot.tree.bodies[spheres[pair.other].center.body].name;
    findings.push_back({actuator::Severity::kViolation, "self-collision", one, pair.time_s,
                        pair.gap_m, 0.0, "m",
                        fmt::format("{} and {} meet: their spheres overlap by {:.4g} m at t = "
                                    "{} s",
                                    one, other, -pair.gap_m, io::time_text(pair.time_s))});
  }
  return findings;
}

}  // namespace torquewright::hopper
