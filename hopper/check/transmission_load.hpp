// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/gear_torque.hpp"
#include "hopper/check/window_load.hpp"

namespace torquewright::hopper {

/// What passes one transmission at most: the mean over a window, in contact or not, driving or
/// driven. docs/derivations/whole_body_check.md eq. (12).
struct TransmissionLoad {
  std::string drive;
  double ratio = 1.0;
  WindowLoad joint;            ///< At the actuator's output, behind the mesh, in Nm.
  WindowLoad motor;            ///< At the rotor, before it.
  double peak_joint_Nm = 0.0;  ///< Of the torque itself, impacts apart.
  double peak_motor_Nm = 0.0;
  double peak_time_s = 0.0;
  double window_s = 0.0;    ///< Shorter than asked for where the motion is.
  double rotor_Nm_s = 0.0;  ///< The greatest impulse that an impact takes to change its rotor's
                            ///< speed, at the output; 0: none.
  double impact_time_s = 0.0;
  double doubt_Nm_s = 0.0;    ///< The greatest of an interval's, at the output: what samples miss.
  double doubt_time_s = 0.0;  ///< At which that interval ends.
  std::optional<TransmissionLimit> limit;
  actuator::Verdict verdict = actuator::Verdict::kPass;  ///< Passes without a limit.

  /// On the side of its limit; the motor's where there is none.
  bool is_judged_at_joint() const { return limit && limit->side == GearSide::kJoint; }
  const WindowLoad& judged() const { return is_judged_at_joint() ? joint : motor; }
};

/// The names, ratios and limits of a robot's drives, nothing on them yet.
std::vector<TransmissionLoad> unloaded_transmissions(const Robot& robot);

/// The verdict on a load: its worst window beside its limit.
actuator::Verdict verdict_of(const TransmissionLoad& load);

/// One a drive.
std::vector<TransmissionLoad> transmission_loads(const CheckedMotion& checked,
                                                 const GearTorque& gears);

/// What there is to say of them, a finding each: a violation, a warning where the samples leave it
/// open, or a note.
std::vector<Finding> transmission_findings(const std::vector<TransmissionLoad>& loads);

}  // namespace torquewright::hopper
