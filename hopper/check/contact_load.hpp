// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/checked_motion.hpp"

namespace torquewright::hopper {

/// What contacts ask of one actuator (seed 000, "Transmission load regularization"): the mean,
/// over a window, of the magnitude of the torque that contact forces and impulses make at its
/// output through J^T. It is a figure to compare with the seed's; it does not pass the gears (that
/// is TransmissionLoad), so nothing is judged by it.
struct ContactLoad {
  std::string drive;
  double ratio = 1.0;
  double joint_Nm = 0.0;         ///< At the actuator's output, the largest of all windows.
  double motor_Nm = 0.0;         ///< The same at the motor: over the ratio.
  double time_s = 0.0;           ///< At which that window begins.
  double steady_joint_Nm = 0.0;  ///< Without the impulses of jolts, in that window.
  double impulse_Nm_s = 0.0;     ///< The largest jolt's part, at the output.
  double impulse_time_s = 0.0;
};

/// One a drive. docs/derivations/whole_body_check.md eq. (20).
std::vector<ContactLoad> contact_loads(const CheckedMotion& checked);

}  // namespace torquewright::hopper
