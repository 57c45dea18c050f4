// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/mechanisms/mechanism_type_spec.hpp"

// One line for each type; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_MECHANISM(type) \
  type(direct) type(parallel) type(four_bar) type(parallel_ankle) type(loop)

namespace torquewright::hopper::mechanisms {

#define TORQUEWRIGHT_DECLARE(name) extern const MechanismType name;
TORQUEWRIGHT_EVERY_MECHANISM(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::mechanisms
