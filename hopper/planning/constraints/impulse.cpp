// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/cone.hpp"
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/typical_sizes.hpp"

namespace torquewright::hopper {
namespace {

void add(const Site& site, optimization::Program& program) {
  if (!site.variables().has_impact) return;
  add_cone(site, constraints::impulse.name, site.variables().impulses, typical::kImpulse_N_s, 0.0,
           program);
}

}  // namespace

const Constraint constraints::impulse{"impulse", "N s",
                                      "what the ground gives in an impact is within the friction "
                                      "cone, and pushes",
                                      Where::kPhase, add};

}  // namespace torquewright::hopper
