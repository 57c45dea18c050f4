// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {

GearTrain gear_train(const Problem& problem, const Design& design) {
  GearTrain train{problem.topology,
                  design.teeth,
                  design.profile_shift,
                  design.planet_count,
                  io::nearest(design.module_mm),
                  {}};
  if (train.shifts.empty()) train.shifts.assign(design.teeth.size(), 0.0);
  if (design.layer_2_module_mm) train.layer_2_module_mm = io::nearest(*design.layer_2_module_mm);
  return train;
}

}  // namespace torquewright::gearbox
