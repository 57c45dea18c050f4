// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::hopper {

/// The side of a gearbox on which a torque is meant.
enum class GearSide { kMotor, kJoint };

/// The greatest load that a transmission may pass on, without its own rotor's torque.
struct TransmissionLimit {
  double torque_Nm = 0.0;
  GearSide side = GearSide::kJoint;
  std::string source;  ///< Words: "stated", or what of the gear's strength sets it.
};

}  // namespace torquewright::hopper
