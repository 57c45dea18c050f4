// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/friction/joint_friction.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// What simulator and drive give to the load, where the simulator's joint has the drive's friction.
/// `direction` is that of the motion, also at rest.
class FrictionAnswers {
 public:
  /// Refers to the drive with its friction.
  FrictionAnswers(const Actuator& whole, const OperatingConditions& conditions,
                  const JointFriction& friction, DryFriction dry);

  /// The simulator's torque on the load for one of its motor: less the joint's friction.
  double simulated_Nm(double motor_Nm, double speed_rad_s, double direction) const;

  /// The drive's torque on the load for the motor's, in Nm at the output: over all angles.
  Span given_Nm(double motor_Nm, double speed_rad_s, double direction) const;
  /// The region of the drive with its friction.
  JointRange region(double speed_rad_s) const;

 private:
  double joint_Nm(double speed_rad_s, double direction) const;
  double slipped_Nm(double region_Nm, double speed_rad_s) const;

  const Actuator& whole_;
  JointFriction friction_;
  DryFriction dry_;
  double temperature_K_;
  Region region_;
};

}  // namespace torquewright::actuator
