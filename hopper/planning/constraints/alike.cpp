// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/affine_rows.hpp"

namespace torquewright::hopper {
namespace {

/// The phases that end with a take-off.
std::vector<std::size_t> push_offs(const Site& site) {
  std::vector<std::size_t> phases;
  for (std::size_t p = 0; p + 1 < site.mesh.size(); ++p) {
    if (site.mesh[p + 1].stance.is_flight()) phases.push_back(p);
  }
  return phases;
}

/// Rows in which numbers of one take-off equal those of the next.
void add_equal(const Site& site, const std::vector<int>& one, const std::vector<int>& other,
               double scale, optimization::Program& program) {
  const auto count = static_cast<Eigen::Index>(one.size());
  Eigen::MatrixXd matrix(count, 2 * count);
  matrix << Eigen::MatrixXd::Identity(count, count), -Eigen::MatrixXd::Identity(count, count);
  program.add_rows(std::make_unique<const AffineRows>(
      site.named(constraints::alike.name), in_order({one, other}),
      std::vector<optimization::Bounds>(one.size(), equal_to(0.0)),
      std::vector<double>(one.size(), scale), matrix));
}

/// The foot's place follows from its posture, as it stands on the ground.
void add(const Site& site, optimization::Program& program) {
  if (!site.options.has_alike_hops) return;
  const std::vector<std::size_t> phases = push_offs(site);
  for (std::size_t i = 1; i < phases.size(); ++i) {
    Site at = site;
    at.phase = phases[i];
    const PointVariables& one = site.phases[phases[i - 1]].points.back();
    const PointVariables& other = at.variables().points.back();
    add_equal(at, at.posture(one), at.posture(other), typical::kAngle_rad, program);
    add_equal(at, at.posture_rates(one), at.posture_rates(other), typical::kSpeed, program);
  }
}

}  // namespace

const Constraint constraints::alike{
    "alike", "rad or rad/s",
    "where asked for, every flight begins with the posture and the rates of the one before",
    Where::kMotion, add};

}  // namespace torquewright::hopper
