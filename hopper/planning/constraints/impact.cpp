// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

void add(const Site& site, optimization::Program& program) {
  const PhaseVariables& variables = site.variables();
  if (!variables.has_impact) return;
  const PointVariables& point = variables.points.front();
  const auto rows = static_cast<std::size_t>(site.moving());
  program.add_rows(jet_rows(
      site.named(constraints::impact.name),
      in_order({site.posture(point), numbers_from(variables.velocity_before, site.moving()),
                numbers_from(point.velocity, site.moving()),
                numbers_from(variables.impulses, site.forces())}),
      std::vector<optimization::Bounds>(rows, equal_to(0.0)),
      std::vector<double>(rows, typical::kImpulse_N_s), ImpactLaw{site.scratch, site.stance()}));
}

}  // namespace

const Constraint constraints::impact{
    "impact", "N s or Nm s",
    "where a phase touches what the one before did not, velocities jump by the impulses that rigid "
    "bodies get there",
    Where::kPhase, add};

}  // namespace torquewright::hopper
