// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {

Cutters stated_cutters(const Problem& problem) {
  const StatedCutters& stated = problem.cutters;
  Cutters cutters;
  if (stated.hob_tip_radius) cutters.hob_tip_radius = io::nearest(*stated.hob_tip_radius);
  if (stated.shaper_tip_radius) cutters.shaper_tip_radius = io::nearest(*stated.shaper_tip_radius);
  cutters.shaper_teeth = stated.shaper_teeth;
  if (stated.hob_addendum) cutters.hob_addendum = io::nearest(*stated.hob_addendum);
  if (stated.shaper_addendum) cutters.shaper_addendum = io::nearest(*stated.shaper_addendum);
  return cutters;
}

GearTrain gear_train(const Problem& problem, const Design& design) {
  GearTrain train{problem.topology,
                  design.teeth,
                  design.profile_shift,
                  design.planet_count,
                  io::nearest(design.module_mm),
                  {},
                  stated_cutters(problem)};
  if (train.shifts.empty()) train.shifts.assign(design.teeth.size(), 0.0);
  if (design.layer_2_module_mm) train.layer_2_module_mm = io::nearest(*design.layer_2_module_mm);
  return train;
}

}  // namespace torquewright::gearbox
