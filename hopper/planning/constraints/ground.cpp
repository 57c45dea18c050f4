// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "hopper/planning/constraints/cone.hpp"
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/typical_sizes.hpp"

namespace torquewright::hopper {
namespace {

/// What each end of the sole bears at least, of the load.
double edge(const Site& site) {
  const bool stands = (site.phase == 0 && site.index == 0) ||
                      (site.is_last_phase() && site.index + 1 == site.variables().points.size());
  // Where it stands the load is near the middle of the sole: each end bears nearly half of it.
  if (stands) return 0.5 - kStandsWithin;
  return edge_at(site, site.mesh[site.phase].share_at(site.index));
}

void add(const Site& site, optimization::Program& program) {
  if (site.stance().is_flight()) return;
  add_cone(site, constraints::ground.name, site.point().forces, typical::kForce_N, edge(site),
           program);
}

std::vector<PlanLimit> limits(const Site& site, const std::vector<double>& values) {
  if (site.stance().is_flight()) return {};
  const Eigen::Map<const Eigen::VectorXd> forces(values.data() + site.point().forces,
                                                 site.forces());
  const double load_N = forces.tail(forces.size() - 1).sum();
  std::vector<PlanLimit> out{
      {"friction", friction_of(site) * load_N - std::abs(forces[0]), site.model.weight_N}};
  if (!site.stance().is_flat() || tips(site)) return out;
  const double least_N = site.options.margins.center_of_pressure * load_N;
  out.push_back(
      {"centre of pressure", std::min(forces[1], forces[2]) - least_N, site.model.weight_N});
  return out;
}

}  // namespace

const Constraint constraints::ground{
    "ground",
    "N",
    "what the ground gives is within the friction cone and its place within the sole, at rest near "
    "the middle",
    Where::kInstant,
    add,
    limits};

}  // namespace torquewright::hopper
