// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/region/gear_losses.hpp"

namespace torquewright::actuator {

/// Torques that a sample asks for, in Nm at the output.
struct GearedTorque {
  /// Torque of the motor: the torque on the load that it could hold instead.
  double motor_Nm = 0.0;
  double teeth_Nm = 0.0;  ///< Torque of the gears, behind their mesh.
};

/// Splits a torque at the joint by where the rotor stands: its inertia between the motor and the
/// teeth, that of the gears behind these. What turns the rotor loads no teeth and is lost in no
/// mesh. docs/derivations/whole_body_check.md eq. (14) to (16), check.md eq. (12), (13).
class RotorBeforeMesh {
 public:
  explicit RotorBeforeMesh(const Actuator& actuator);

  /// Returns what passes motor and mesh for a joint torque that includes all inertia of rotor and
  /// gears, as simulators have it. At rest the mesh still drives in the direction of the speed
  /// `before_rad_s`; where that is 0 too, in the direction of the acceleration.
  GearedTorque of(double speed_rad_s, double torque_Nm, double acceleration_rad_s2,
                  double before_rad_s) const;

  /// Returns the actuator whose region holds `motor_Nm`, with teeth that bear any load. A gear that
  /// locks itself is returned as it is.
  Actuator behind_any_teeth(Actuator actuator) const;

 private:
  double factor(double torque_Nm, double direction) const {
    return torque_Nm * direction > 0.0 ? driving_ : driven_;
  }

  double rotor_kg_m2_;
  /// Torque behind over torque before the mesh, driving and driven back.
  double driving_, driven_;
};

}  // namespace torquewright::actuator
