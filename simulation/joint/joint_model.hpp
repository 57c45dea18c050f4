// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/heat/heat_model.hpp"
#include "actuator/motor/actuator.hpp"
#include "simulation/excitation.hpp"
#include "simulation/joint/elastic_train.hpp"
#include "simulation/joint/joint_state.hpp"
#include "simulation/joint/winding_circuit.hpp"

namespace torquewright::simulation {

/// Forces on the motor's side of a joint at an instant, apart from acceleration, in Nm at the
/// output: the load gets gain(before mesh) (before_mesh_Nm - inertia acceleration) (1 + ripple
/// ratio) + ripple.
struct JointForces {
  double current_A = 0.0;
  double motor_Nm = 0.0;     ///< Torque of the motor, with its lag.
  double friction_Nm = 0.0;  ///< Torque of friction, with its sign.
  double cogging_Nm = 0.0;
  double before_mesh_Nm = 0.0;  ///< Sum of all torques before the mesh.
  double ripple_Nm = 0.0;
  double ripple_ratio = 0.0;
  /// Torque after over before the mesh, where that before is positive.
  double gain_positive = 1.0;
  double gain_negative = 1.0;  ///< The same where it is negative; infinite if the gear locks.
  double gain(bool positive) const { return positive ? gain_positive : gain_negative; }
};

/// One actuator, prepared to be evaluated many times. The laws are those of actuator/effects. Keeps
/// a reference to the actuator.
class JointModel {
 public:
  /// `felt_inertia_kg_m2` is the inertia that the joint feels at the start, which bounds the step;
  /// 0 where the motion is imposed.
  JointModel(const actuator::Actuator& actuator, double felt_inertia_kg_m2,
             const SimulationOptions& options);

  JointState initial(const JointStart& start) const;

  /// Returns the forces; `direction` is that of the motor's motion, also at rest.
  JointForces forces(const JointState& state, double direction, const DriveNow& drive) const;

  /// Advances the states with a rate of their own (lag, bristles, current) with all else held;
  /// exact for rates that are linear in their state.
  void advance_states(JointState& state, const DriveNow& drive, double step_s) const;
  /// Sets these states to where they would settle: the lag's torque to its command, bristles of a
  /// joint that moves to full slip (at rest they stay as they are).
  void settle_states(JointState& state, const DriveNow& drive) const;
  /// Advances the two thermal nodes; does nothing without thermal data.
  void heat(JointState& state, double current_A, double step_s) const;

  const WindingCircuit& circuit() const { return circuit_; }

  ElasticTrain::Twist twist(const JointState& state) const { return train_.twist(state); }
  /// Twist under a torque of the train on the load, at rest; 0 of a rigid train.
  double twist_rad_under(double torque_Nm) const { return train_.twist_rad_under(torque_Nm); }
  /// Returns the torque before the mesh that belongs to a torque after it.
  double carried_Nm(double after_mesh_Nm, double direction) const;

  /// Greatest coupling of the output to rotor and frame: torque by its angle (springs, stops, the
  /// train; bristles of a rigid one) and by its speed.
  double coupling_Nm_rad() const;
  double coupling_Nm_s_rad() const { return train_.damping_Nm_s_rad(); }

  bool is_elastic() const { return train_.is_elastic(); }
  double inertia_kg_m2() const { return inertia_kg_m2_; }
  double ratio() const { return actuator_.transmission.ratio; }
  double longest_step_s() const { return longest_step_s_; }

 private:
  template <typename Change>
  void change_states(JointState& state, const DriveNow& drive, Change change) const;
  /// Torque of the motor before its lag, in Nm at the output.
  double commanded_Nm(const actuator::Instant& at, const DriveNow& drive) const;
  double state_torque_Nm(const JointState& state, actuator::Instant at, double drag_factor,
                         double* motor_Nm) const;

  const actuator::Actuator& actuator_;
  WindingCircuit circuit_;
  double inertia_kg_m2_ = 0.0;
  ElasticTrain train_;
  std::optional<actuator::HeatModel> heat_;
  double gain_[2][2] = {};  ///< Gain by direction (forward, backward) and by sign before the mesh.
  double longest_step_s_ = 0.0;
};

}  // namespace torquewright::simulation
