// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/load_model.hpp"
#include "identification/simulation.hpp"

namespace torquewright::identification {

/// -1, 0 or 1.
inline double sign_of(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

/// What changes in one joint while time goes on. Motor quantities are referred to the output.
struct JointState {
  double position_rad = 0.0, speed_rad_s = 0.0;              ///< Output.
  double motor_position_rad = 0.0, motor_speed_rad_s = 0.0;  ///< The same where it is rigid.
  std::vector<double> of_effect;  ///< Of effects that have one, in the document's order.
  double current_A = 0.0;         ///< Where the winding's inductance counts.
  double winding_K = 298.15, case_K = 298.15;
  double held_Nm = 0.0;  ///< On the load while an imposed motion rests.
};

/// What the drive prescribes at an instant.
struct DriveNow {
  DriveKind kind = DriveKind::kCurrent;
  double value = 0.0;
  double position_gain_1_rad = 0.0;
  std::optional<double> bus_V;
};

/// What the motor's side of a joint does at an instant, acceleration apart, in Nm at the output:
/// the load gets gain(before mesh) (before_mesh_Nm - inertia acceleration) (1 + ripple ratio) +
/// ripple.
struct JointForces {
  double current_A = 0.0;
  double motor_Nm = 0.0;     ///< With lag.
  double friction_Nm = 0.0;  ///< With its sign.
  double cogging_Nm = 0.0;
  double before_mesh_Nm = 0.0;  ///< The sum.
  double ripple_Nm = 0.0;
  double ripple_ratio = 0.0;
  double gain_positive = 1.0;  ///< After over before the mesh, where before is positive ...
  double gain_negative = 1.0;  ///< ... and negative; may be infinite: it locks.
  double gain(bool positive) const { return positive ? gain_positive : gain_negative; }
};

/// One actuator, ready to be asked many times. The laws are those of actuator/effects.
class JointModel {
 public:
  JointModel(const actuator::Actuator& actuator, double load_inertia_kg_m2,
             const SimulationOptions& options);

  JointState initial(const JointStart& start) const;

  /// `direction`: of the motor's motion, also at rest.
  JointForces forces(const JointState& state, double direction, const DriveNow& drive) const;

  /// Advances what has a rate of its own (lag, bristles, current) with all else held; exact for
  /// rates that are linear in their state.
  void advance_states(JointState& state, const DriveNow& drive, double step_s) const;
  /// Sets them to where they would settle: the lag's torque to its command, bristles of a joint
  /// that moves to full slip (of one at rest they stay as they are).
  void settle_states(JointState& state, const DriveNow& drive) const;
  /// Two thermal nodes; nothing without thermal data.
  void heat(JointState& state, double current_A, double step_s) const;

  double current_A(const JointState& state, const DriveNow& drive) const;
  double bus_V(const JointState& state, const DriveNow& drive, double current_A) const;
  double voltage_V(const JointState& state, const DriveNow& drive, double current_A) const;

  /// Torque of the twisted train on the load, its damping part, and what is stored in the twist.
  struct Twist {
    double torque_Nm = 0.0, damping_Nm = 0.0, stored_J = 0.0;
  };
  Twist twist(const JointState& state) const;
  /// Torque before the mesh that belongs to a torque after it.
  double carried_Nm(double after_mesh_Nm, double direction) const;

  bool is_elastic() const { return is_elastic_; }
  double inertia_kg_m2() const { return inertia_kg_m2_; }
  double ratio() const { return actuator_.transmission.ratio; }
  double longest_step_s() const { return longest_step_s_; }

 private:
  template <typename Change>
  void change_states(JointState& state, const DriveNow& drive, Change change) const;
  actuator::Instant instant(const JointState& state, double direction) const;
  double quasi_static_A(const JointState& state, const DriveNow& drive, double bus_V) const;
  double applied_V(const JointState& state, const DriveNow& drive, double bus_V) const;
  double state_torque_Nm(const JointState& state, actuator::Instant at, double drag_factor,
                         double* motor_Nm) const;

  const actuator::Actuator& actuator_;
  Winding winding_;
  double inductance_H_ = 0.0;  ///< 0: quasi-static.
  double inertia_kg_m2_ = 0.0;
  bool is_elastic_ = false;
  const actuator::Effect* gap_ = nullptr;
  const actuator::Effect* spring_ = nullptr;
  double contact_Nm_rad_ = 0.0, contact_Nm_s_rad_ = 0.0;  ///< Of a gap without a stated spring.
  double gain_[2][2] = {};  ///< By direction (forward, backward) and sign before the mesh.
  double longest_step_s_ = 0.0;
};

}  // namespace torquewright::identification
