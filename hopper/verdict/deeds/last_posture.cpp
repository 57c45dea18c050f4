// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "hopper/verdict/every_deed.hpp"

namespace torquewright::hopper {
namespace {

/// A joint without range turns on: where it stands is where the robot has rolled to.
bool has_range(const dynamics::Joint& joint) {
  return std::isfinite(joint.limits.position_min) && std::isfinite(joint.limits.position_max);
}

Deed joint_deed(const dynamics::Joint& joint, double planned, double done,
                const DeedTolerances& tolerances) {
  const bool is_slide = joint.kind == dynamics::JointKind::kPrismatic;
  Deed deed;
  deed.name = "last_posture";
  deed.of = joint.name;
  deed.unit = is_slide ? "m" : "rad";
  deed.planned = planned;
  deed.done = done;
  deed.off = std::abs(done - planned);
  deed.tolerance = is_slide ? tolerances.slide_m : tolerances.joint_rad;
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence = fmt::format("{} ends at {:.3g} in the place of {:.3g} {}", joint.name, done,
                              planned, deed.unit);
  return deed;
}

}  // namespace

// The joint that is farthest from the motion's last sample, by its tolerance.
std::vector<Deed> last_posture(const Attempt& attempt) {
  const dynamics::Tree& tree = attempt.robot.tree;
  ReferenceInstant goal;
  attempt.reference.at(attempt.reference.ends_s(), goal);
  const Eigen::VectorXd& last = attempt.record.rows.back().position;
  std::vector<Deed> worst;
  // Positions end with one for each joint, in the order of the bodies.
  Eigen::Index at = tree.position_size() - static_cast<Eigen::Index>(tree.bodies.size()) + 1;
  for (std::size_t body = 1; body < tree.bodies.size(); ++body, ++at) {
    const dynamics::Joint& joint = tree.bodies[body].joint;
    if (!has_range(joint)) continue;
    Deed deed = joint_deed(joint, goal.position[at], last[at], attempt.tolerances);
    const bool is_worst =
        worst.empty() || deed.off / deed.tolerance > worst.front().off / worst.front().tolerance;
    if (is_worst) worst = {std::move(deed)};
  }
  return worst;
}

}  // namespace torquewright::hopper
