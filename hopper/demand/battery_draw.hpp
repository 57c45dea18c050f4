// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// Of a robot with a battery: a note on its drives that are known by their curve, of which nobody
/// knows what they take; with what leaves their outputs.
std::vector<Finding> battery_draw(const CheckedMotion& checked);

}  // namespace torquewright::hopper
