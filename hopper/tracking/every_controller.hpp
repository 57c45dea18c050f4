// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/tracking/controller_kind.hpp"

// One line for each controller; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_CONTROLLER(controller) \
  controller(lqr) controller(pd) controller(weighing) controller(osc) controller(stepping)

namespace torquewright::hopper::controllers {

#define TORQUEWRIGHT_DECLARE(name) extern const ControllerKind name;
TORQUEWRIGHT_EVERY_CONTROLLER(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::controllers
