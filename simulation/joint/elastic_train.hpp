// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"
#include "simulation/joint/joint_state.hpp"

namespace torquewright::simulation {

/// Whether the effect makes a train elastic: a gap that is open, or a spring that gives way.
bool makes_train_elastic(const actuator::Effect& effect);

/// Whether the actuator's effects let the motor turn without its output: a gap, or a finite
/// stiffness between them.
bool states_elastic_train(const actuator::Actuator& actuator);

/// A train with backlash or compliance, which lets the motor have a position of its own. Keeps a
/// reference to the actuator.
class ElasticTrain {
 public:
  /// `inertia_kg_m2` is the inertia of the motor's side, at the output. With 0 the train counts as
  /// rigid.
  ElasticTrain(const actuator::Actuator& actuator, double inertia_kg_m2);

  bool is_elastic() const { return is_elastic_; }

  /// Torque of the twisted train on the load, the part of it by damping, and the energy stored in
  /// the twist.
  struct Twist {
    double torque_Nm = 0.0, damping_Nm = 0.0, stored_J = 0.0;
  };
  Twist twist(const JointState& state) const;

  /// Greatest stiffness and damping of the tight train: torque on the load by its angle and by its
  /// speed; 0 for a rigid train.
  double stiffness_Nm_rad() const;
  double damping_Nm_s_rad() const;

  /// Returns the twist (motor ahead of the load, in rad at the output) under which the train, at
  /// rest, exerts that torque on the load: the inverse of twist(). 0 without torque and for a rigid
  /// train.
  double twist_rad_under(double torque_Nm) const;

  /// Whether the train carries torque: it is elastic, and no gap is open.
  bool is_tight(const JointState& state) const;

  /// Longest step that follows the twist as it swings between motor and load. An inertia of 0
  /// stands for a load that no torque moves. Only for an elastic train.
  double longest_step_s(double felt_inertia_kg_m2) const;

 private:
  double spring_Nm_rad() const;
  double hysteresis_Nm(const JointState& state, const actuator::Instant& at) const;

  const actuator::Actuator& actuator_;
  double inertia_kg_m2_;
  bool is_elastic_;
  const actuator::Effect* gap_;          ///< Backlash of the actuator; null: none.
  const actuator::Effect* spring_;       ///< Compliance of the actuator; null: none.
  const actuator::Effect* hysteresis_;   ///< Hysteresis beside the spring; null: none.
  std::size_t state_of_hysteresis_ = 0;  ///< Index of its state in JointState::of_effect.
  /// Stiffness and damping of a gap without a stated spring.
  double contact_Nm_rad_ = 0.0, contact_Nm_s_rad_ = 0.0;
};

}  // namespace torquewright::simulation
