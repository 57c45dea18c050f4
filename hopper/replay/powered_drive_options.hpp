// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "actuator/region/operating_conditions.hpp"

namespace torquewright::hopper {

/// Bounds that a drive's torque is held to.
enum class DriveLimits {
  kMor,  ///< Its motor operating region at the voltage and temperature of the instant.
  /// The greatest torque at rest of its region at the start, at any speed, and no driving torque
  /// beyond the no-load speed there, both at the open circuit's voltage. Neither battery nor heat
  /// holds it back: what they would say is only reported.
  kBox,
};

struct PoweredDriveOptions {
  DriveLimits limits = DriveLimits::kMor;
  actuator::OperatingConditions conditions;  ///< Conditions at the start.
  /// Coulomb friction beyond what the documents know, at each drive's output (drives x 1, not
  /// negative), which nobody compensates. Empty: none.
  Eigen::VectorXd further_friction_Nm;
  /// By this factor each drive's motor makes more torque of a current than its document says
  /// (drives x 1, positive), which nobody knows. Empty: 1.
  Eigen::VectorXd motor_strength_factor = {};
};

}  // namespace torquewright::hopper
