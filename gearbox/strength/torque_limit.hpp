// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "gearbox/strength/tooth_load.hpp"

namespace torquewright::gearbox {

enum class FailureMode {
  kBending,  ///< The root breaks.
  kContact,  ///< The flank is crushed or pitted.
};

/// The torque at which the first tooth comes down to the demanded safety.
struct TorqueLimit {
  double motor_Nm = 0.0;  ///< Torque at the sun.
  double joint_Nm = 0.0;  ///< The same torque at the output, without losses.
  std::string_view gear;
  std::string_view mesh;
  FailureMode mode = FailureMode::kBending;
};

/// Limits against a single load, and for the cycles of the case.
struct TorqueLimits {
  TorqueLimit once;
  TorqueLimit for_cycles;
};

/// Computes the limits in closed form: bending goes with the torque, pressure with its square root.
/// docs/derivations/strength.md eq. (14). Requires a train without objections.
TorqueLimits torque_limits(const StrengthCase& strength);

}  // namespace torquewright::gearbox
