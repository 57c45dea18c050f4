// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"

namespace torquewright::hopper {
namespace {

std::vector<PlanLimit> limits(const Site& site, const std::vector<double>& values) {
  const optimization::Bounds& may_s = site.mesh[site.phase].duration_s;
  const double duration_s = values[static_cast<std::size_t>(site.variables().duration)];
  return {{"longest duration", may_s.upper - duration_s, may_s.upper},
          {"shortest duration", duration_s - may_s.lower, may_s.upper}};
}

}  // namespace

const Constraint constraints::duration{
    "duration",
    "s",
    "each phase takes as long as one of its kind may, by the bounds of the unknowns",
    Where::kPhase,
    nullptr,
    limits};

}  // namespace torquewright::hopper
