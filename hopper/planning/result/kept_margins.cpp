// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/result/kept_margins.hpp"

#include <algorithm>
#include <limits>

#include "hopper/planning/constraints/cone.hpp"
#include "hopper/planning/plane/sole_load.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Of the joints that move, how near one is to an end of its range.
double least_room_rad(const Site& site, const Motion& motion, Index sample) {
  const dynamics::Tree& tree = site.model.plane.robot.tree;
  const Index base =
      motion.positions.rows() + 1 - static_cast<Index>(tree.bodies.size());  // rows of its place
  double least = kNone;
  for (const std::size_t body : site.model.plane.joints) {
    const dynamics::JointLimits& limits = tree.bodies[body].joint.limits;
    const double at = motion.positions(base + static_cast<Index>(body) - 1, sample);
    least = std::min({least, at - limits.position_min, limits.position_max - at});
  }
  return least;
}

void look_at_ground(const Site& site, double share, const SoleLoad& load, KeptMargins& kept) {
  if (!(load.load_N() > kLeastLoad * site.model.weight_N)) return;
  const double coefficient = friction_of(site) / (1.0 - site.options.margins.friction);
  kept.friction = std::min(kept.friction, 1.0 - load.friction() / coefficient);
  const bool is_tipping = edge_at(site, share) < site.options.margins.center_of_pressure;
  if (!site.stance().is_flat() || is_tipping) return;
  kept.center_of_pressure = std::min(kept.center_of_pressure, load.lesser_share());
}

}  // namespace

KeptMargins kept_margins(const Site& program, const PlannedMotion& plan, const Motion& motion,
                         const Eigen::MatrixXd& forces_N) {
  KeptMargins kept{kNone, kNone, kNone, kNone};
  Site site = program;
  for (site.phase = 0; site.phase < plan.phases.size(); ++site.phase) {
    const PlannedPhase& phase = plan.phases[site.phase];
    const double duration_s = phase.end_s() - phase.begin_s();
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      const double share = (motion.time_s(sample) - phase.begin_s()) / duration_s;
      if (!(share > 0.0 && share < 1.0)) continue;
      double& room_rad = phase.flies() ? kept.flight_position_rad : kept.position_rad;
      room_rad = std::min(room_rad, least_room_rad(site, motion, sample));
      if (phase.flies() || sample >= forces_N.cols()) continue;
      look_at_ground(site, share, sole_load(site.model.plane, forces_N, sample), kept);
    }
  }
  return kept;
}

}  // namespace torquewright::hopper
