// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/gear_torque.hpp"
#include "hopper/check/window_load.hpp"

namespace torquewright::hopper {

/// The greatest load of one transmission: the mean over a window of what passes its gears, in
/// contact or not, driving or driven (docs/derivations/whole_body_check.md eq. (12)).
struct TransmissionLoad {
  std::string drive;
  double ratio = 1.0;
  WindowLoad joint;            ///< Load at the actuator's output, behind the mesh, in Nm.
  WindowLoad motor;            ///< Load at the rotor, before the mesh.
  double peak_joint_Nm = 0.0;  ///< Greatest torque itself, impacts apart.
  double peak_motor_Nm = 0.0;
  double peak_time_s = 0.0;
  /// Length of the window; shorter than asked for where the motion is shorter.
  double window_s = 0.0;
  double rotor_Nm_s = 0.0;  ///< The greatest impulse that an impact takes to change its rotor's
                            ///< speed, at the output; 0: none.
  double impact_time_s = 0.0;
  /// Greatest doubt of an interval, at the output: what samples do not tell.
  double doubt_Nm_s = 0.0;
  double doubt_time_s = 0.0;  ///< Time at which that interval ends.
  std::optional<TransmissionLimit> limit;
  actuator::Verdict verdict = actuator::Verdict::kPass;  ///< Verdict; it passes without a limit.

  /// Whether it is judged at the joint, where its limit is stated there; else at the motor.
  bool is_judged_at_joint() const { return limit && limit->side == GearSide::kJoint; }
  const WindowLoad& judged() const { return is_judged_at_joint() ? joint : motor; }
};

/// Returns the names, ratios and limits of a robot's drives, without loads.
std::vector<TransmissionLoad> unloaded_transmissions(const Robot& robot);

/// Judges a load: its worst window against its limit.
actuator::Verdict verdict_of(const TransmissionLoad& load);

/// Computes the loads, one for each drive.
std::vector<TransmissionLoad> transmission_loads(const CheckedMotion& checked,
                                                 const GearTorque& gears);

/// Returns a finding on each load: a violation, a warning where the samples leave it open, or a
/// note.
std::vector<Finding> transmission_findings(const std::vector<TransmissionLoad>& loads);

}  // namespace torquewright::hopper
