// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {

/// Returns the conditions that any train must meet to exist, whatever it is for, with profile shift
/// or without: planets equally spaced and clear of each other, teeth that are not pointed, ring
/// tips outside their base circles, planets and rings that leave each other. Names of
/// docs/gearbox_constraints.md. Meshes without a working angle have no such values: strength's
/// loaded_train() objects to them.
std::vector<ConstraintReport> existence_conditions(const GearTrain& train);

/// Returns those that are violated.
std::vector<ConstraintReport> what_cannot_exist(const GearTrain& train);

}  // namespace torquewright::gearbox
