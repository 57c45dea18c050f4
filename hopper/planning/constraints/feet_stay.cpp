// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

void add(const Site& site, optimization::Program& program) {
  const Stance& on = site.stance();
  if (on.is_flight() || on.holds_place()) return;
  const PointVariables& point = site.point();
  program.add_rows(jet_rows(site.named(constraints::feet_stay.name),
                            in_order({site.posture(point), site.posture_rates(point),
                                      numbers_from(point.acceleration, site.moving())}),
                            std::vector<optimization::Bounds>(on.force_count(), equal_to(0.0)),
                            std::vector<double>(on.force_count(), typical::kAcceleration),
                            ContactAccelerationLaw{site.scratch, on}));
}

}  // namespace

const Constraint constraints::feet_stay{
    "feet stay", "m/s^2",
    "what stands on another point than the rearmost, which bounds hold, does not accelerate",
    Where::kInstant, add};

}  // namespace torquewright::hopper
