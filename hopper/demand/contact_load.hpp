// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// The torque that contacts ask of one actuator (seed 000, "Transmission load regularization"): the
/// mean, over a window, of the magnitude of the torque that contact forces and impulses make at its
/// output through J^T. It is a figure to compare with the seed's; it does not pass the gears (that
/// is TransmissionLoad), so nothing is judged by it.
struct ContactLoad {
  std::string drive;
  double ratio = 1.0;
  double joint_Nm = 0.0;         ///< Load at the actuator's output, the largest of all windows.
  double motor_Nm = 0.0;         ///< The same at the motor: divided by the ratio.
  double time_s = 0.0;           ///< Time at which that window begins.
  double steady_joint_Nm = 0.0;  ///< Load of that window without the impulses of jolts.
  double impulse_Nm_s = 0.0;     ///< Part of the largest jolt, at the output.
  double impulse_time_s = 0.0;
};

/// Computes the loads, one for each drive (docs/derivations/whole_body_check.md eq. (20)).
std::vector<ContactLoad> contact_loads(const CheckedMotion& checked);

}  // namespace torquewright::hopper
