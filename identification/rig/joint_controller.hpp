// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/position_law.hpp"

namespace torquewright::identification {

/// What a rig says of the controller of one joint.
struct JointController {
  actuator::PositionLaw law;
  double delay_s = 0.0;  ///< By which the law has the command late.
  /// Whether the law's numbers are to be found, and are where to begin.
  bool finds_stiffness = false, finds_damping = false, finds_delay = false;
  /// False: nothing is stated to begin with, as of a servo whose gain is not published.
  bool states_stiffness = true;
};

}  // namespace torquewright::identification
