// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

void add(const Site& site, optimization::Program& program) {
  const Stance& on = site.stance();
  if (!site.variables().has_impact || on.holds_place()) return;
  const PointVariables& point = site.variables().points.front();
  program.add_rows(
      jet_rows(site.named(constraints::feet_stop.name),
               in_order({site.posture(point), numbers_from(point.velocity, site.moving())}),
               std::vector<optimization::Bounds>(on.force_count(), equal_to(0.0)),
               std::vector<double>(on.force_count(), typical::kSpeed),
               ContactVelocityLaw{site.scratch, on}));
}

}  // namespace

const Constraint constraints::feet_stop{
    "feet stop", "m/s", "what touches is at rest after an impact, unless bounds say so",
    Where::kPhase, add};

}  // namespace torquewright::hopper
