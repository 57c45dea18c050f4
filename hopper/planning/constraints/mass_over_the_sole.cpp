// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

/// Where the last stance begins after a landing on an edge, the mass is over the sole already, as
/// far as the load has to be: else it creeps there over the edge, which no feedback can help
/// (trial: plans without this fell back in most replays).
void add(const Site& site, optimization::Program& program) {
  Site last = site;
  last.phase = site.mesh.size() - 1;
  if (last.phase == 0 || !last.stance().is_flat() || last.stance_before().points.size() != 1) {
    return;
  }
  const double length_m = site.model.foot_length_m;
  const double within_m = site.options.margins.center_of_pressure * length_m;
  program.add_rows(jet_rows(last.named(constraints::mass_over_the_sole.name),
                            last.posture(last.variables().points.front()),
                            {{within_m, length_m - within_m}}, {typical::kLength_m},
                            LeanLaw{site.scratch}));
}

}  // namespace

const Constraint constraints::mass_over_the_sole{
    "mass over the sole", "m",
    "after a landing on an edge the mass is over the sole where the last stance begins",
    Where::kMotion, add};

}  // namespace torquewright::hopper
