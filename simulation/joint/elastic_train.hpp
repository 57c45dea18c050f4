// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"
#include "simulation/joint/joint_state.hpp"

namespace torquewright::simulation {

/// A train with backlash or compliance, which lets the motor have a position of its own. Keeps a
/// reference to the actuator.
class ElasticTrain {
 public:
  /// `inertia_kg_m2`: of the motor's side, at the output. Without any the train counts as rigid.
  ElasticTrain(const actuator::Actuator& actuator, double inertia_kg_m2);

  bool is_elastic() const { return is_elastic_; }

  /// Torque of the twisted train on the load, its damping part, and what is stored in the twist.
  struct Twist {
    double torque_Nm = 0.0, damping_Nm = 0.0, stored_J = 0.0;
  };
  Twist twist(const JointState& state) const;

  /// The longest step that follows the twist as it swings between motor and load. An inertia of 0
  /// stands for a load that no torque moves otherwise. Only of an elastic train.
  double longest_step_s(double felt_inertia_kg_m2) const;

 private:
  const actuator::Actuator& actuator_;
  double inertia_kg_m2_;
  bool is_elastic_ = false;
  const actuator::Effect* gap_ = nullptr;
  const actuator::Effect* spring_ = nullptr;
  double contact_Nm_rad_ = 0.0, contact_Nm_s_rad_ = 0.0;  ///< Of a gap without a stated spring.
};

}  // namespace torquewright::simulation
