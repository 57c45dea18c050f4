// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

void add(const Site& site, optimization::Program& program) {
  const PointVariables& point = site.point();
  const auto rows = static_cast<std::size_t>(site.moving()) + site.model.plane.held.size();
  std::vector<optimization::Bounds> bounds(rows, equal_to(0.0));
  // In flight the frame's acceleration is gravity's already.
  if (site.stance().is_flight()) bounds[0] = bounds[1] = {};
  program.add_rows(jet_rows(site.named(constraints::equations_of_motion.name),
                            in_order({site.posture(point), site.posture_rates(point),
                                      numbers_from(point.acceleration, site.moving()),
                                      numbers_from(point.drives, site.drives()),
                                      numbers_from(point.forces, site.forces())}),
                            std::move(bounds), std::vector<double>(rows, typical::kForce_N),
                            DynamicsLaw{site.scratch, site.stance()}));
}

}  // namespace

const Constraint constraints::equations_of_motion{
    "equations of motion", "N or Nm",
    "torques and what the ground gives accelerate rigid bodies as they do", Where::kInstant, add};

}  // namespace torquewright::hopper
