// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/region/gear_losses.hpp"

namespace torquewright::actuator {

/// What a sample asks, both in Nm at the output.
struct GearedTorque {
  double motor_Nm = 0.0;  ///< Of the motor: the torque on the load that it could hold instead.
  double teeth_Nm = 0.0;  ///< Of the gears, behind their mesh.
};

/// Splits a torque at the joint by where the rotor stands: its inertia between the motor and the
/// teeth, that of the gears behind these. What turns the rotor loads no teeth and is lost in no
/// mesh. docs/derivations/whole_body_check.md eq. (14) to (16), check.md eq. (12), (13).
class RotorBeforeMesh {
 public:
  explicit RotorBeforeMesh(const Actuator& actuator);

  /// What passes motor and mesh for a joint torque that includes all inertia of rotor and gears, as
  /// simulators have it. At rest
  /// the mesh still drives the way of the speed `before_rad_s`; where that is 0 too the joint
  /// begins to move, the way it is accelerated.
  GearedTorque of(double speed_rad_s, double torque_Nm, double acceleration_rad_s2,
                  double before_rad_s) const;

  /// The actuator whose region holds `motor_Nm`: its teeth bear whatever comes. Of a gear that
  /// locks itself it is the actuator as it is.
  Actuator behind_any_teeth(Actuator actuator) const;

 private:
  double factor(double torque_Nm, double direction) const {
    return torque_Nm * direction > 0.0 ? driving_ : driven_;
  }

  double rotor_kg_m2_;
  double driving_, driven_;  ///< Torque behind over torque before the mesh.
};

}  // namespace torquewright::actuator
