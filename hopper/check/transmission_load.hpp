// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/checked_motion.hpp"

namespace torquewright::hopper {

/// What contacts put on one transmission (seed 000, "Transmission load regularization"): the mean,
/// over a window, of the magnitude of the torque that contact forces and impulses make at the
/// actuator's output through J^T. Its own motor adds to it or not: that is another number.
struct TransmissionLoad {
  std::string drive;
  double ratio = 1.0;
  double joint_Nm = 0.0;         ///< At the actuator's output, the largest of all windows.
  double motor_Nm = 0.0;         ///< The same at the motor: over the ratio.
  double time_s = 0.0;           ///< At which that window begins.
  double steady_joint_Nm = 0.0;  ///< Without the impulses of jolts, in that window.
  double impulse_Nm_s = 0.0;     ///< The largest jolt's part, at the output.
  double impulse_time_s = 0.0;
  double rotor_Nm_s = 0.0;  ///< What changes its rotor's speed in that jolt, through the gears.
  std::optional<TransmissionLimit> limit;
};

/// One a drive. docs/derivations/whole_body_check.md eq. (12).
std::vector<TransmissionLoad> transmission_loads(const CheckedMotion& checked);

}  // namespace torquewright::hopper
