// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {
namespace {

/// As far as the problem states them.
Cutters cutters_of(const StatedCutters& stated) {
  Cutters cutters;
  if (stated.hob_tip_radius) cutters.hob_tip_radius = io::nearest(*stated.hob_tip_radius);
  if (stated.shaper_tip_radius) cutters.shaper_tip_radius = io::nearest(*stated.shaper_tip_radius);
  cutters.shaper_teeth = stated.shaper_teeth;
  return cutters;
}

}  // namespace

GearTrain gear_train(const Problem& problem, const Design& design) {
  GearTrain train{problem.topology,
                  design.teeth,
                  design.profile_shift,
                  design.planet_count,
                  io::nearest(design.module_mm),
                  {},
                  cutters_of(problem.cutters)};
  if (train.shifts.empty()) train.shifts.assign(design.teeth.size(), 0.0);
  if (design.layer_2_module_mm) train.layer_2_module_mm = io::nearest(*design.layer_2_module_mm);
  return train;
}

}  // namespace torquewright::gearbox
