// SPDX-License-Identifier: Apache-2.0
// How near the centre of pressure comes to the edge of what a body stands on. Forces that push lie
// inside by themselves; a small margin says that the foot is about to tip.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "dynamics/point.hpp"
#include "hopper/check/rules/every_rule.hpp"
#include "hopper/contact/support_polygon.hpp"
#include "io/text/time_text.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

struct Nearest {
  double margin_m = std::numeric_limits<double>::infinity();
  double time_s = 0.0;
};

/// Of one body's touching points at one sample; empty where they span no area or carry nothing.
std::optional<double> margin_at(const CheckedMotion& checked, const dynamics::TreeState& state,
                                std::size_t body, Index sample) {
  std::vector<Eigen::Vector2d> points;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  double force_N = 0.0;
  for (std::size_t i = 0; i < checked.robot.contacts.size(); ++i) {
    const auto row = static_cast<Index>(i);
    if (checked.robot.contacts[i].point.body != body || !checked.contacts.touches(row, sample)) {
      continue;
    }
    points.emplace_back(
        dynamics::point_position_m(state, touching_point(checked.robot.contacts[i], state))
            .head<2>());
    const double normal_N = checked.demand.forces_N(3 * row + 2, sample);
    force_N += normal_N;
    moment += normal_N * points.back();
  }
  if (points.size() < 3 || force_N < kBearsLoad * checked.demand.weight_N) return std::nullopt;
  const std::vector<Eigen::Vector2d> polygon = support_polygon(points);
  if (polygon.size() < 3) return std::nullopt;
  return distance_inside(polygon, moment / force_N);
}

}  // namespace

std::vector<Finding> center_of_pressure(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  if (!checked.demand.has_dynamics) return findings;
  const dynamics::Tree& tree = checked.robot.tree;
  std::vector<Nearest> nearest(tree.bodies.size());
  dynamics::TreeState state(tree);
  for (Index sample = 0; sample < checked.motion.samples(); ++sample) {
    if (!checked.contacts.any(sample)) continue;
    state.set(checked.motion.positions.col(sample), checked.motion.velocities.col(sample));
    for (std::size_t body = 0; body < tree.bodies.size(); ++body) {
      const auto margin_m = margin_at(checked, state, body, sample);
      if (!margin_m || *margin_m >= nearest[body].margin_m) continue;
      nearest[body] = {*margin_m, checked.motion.time_s(sample)};
    }
  }
  for (std::size_t body = 0; body < tree.bodies.size(); ++body) {
    if (!std::isfinite(nearest[body].margin_m)) continue;
    findings.push_back({actuator::Severity::kNote, "centre-of-pressure", tree.bodies[body].name,
                        nearest[body].time_s, nearest[body].margin_m, 0.0, "m",
                        fmt::format("{}: the centre of pressure comes to {:.4g} m from the edge of "
                                    "what touches, at t = {} s",
                                    tree.bodies[body].name, nearest[body].margin_m,
                                    io::time_text(nearest[body].time_s))});
  }
  return findings;
}

}  // namespace torquewright::hopper
