// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"
#include "actuator/region/winding.hpp"
#include "simulation/joint/joint_state.hpp"

namespace torquewright::simulation {

/// Computes current and voltage of a joint's winding, and the voltage of its bus. Quasi-static,
/// unless inductance is asked for. Keeps a reference to the actuator.
class WindingCircuit {
 public:
  WindingCircuit(const actuator::Actuator& actuator, bool inductance);

  double current_A(const JointState& state, const DriveNow& drive) const;
  double bus_V(const JointState& state, const DriveNow& drive, double current_A) const;
  double voltage_V(const JointState& state, const DriveNow& drive, double current_A) const;

  /// Whether the current is a state that follows the voltage with a delay.
  bool is_inductive(const DriveNow& drive) const {
    return inductance_H_ > 0.0 && drive.kind >= DriveKind::kVoltage;
  }
  /// Rate of the current, linear in the current, and its derivative by the current.
  struct Rate {
    double current_A_s = 0.0, slope_1_s = 0.0;
  };
  Rate current_rate(const JointState& state, const DriveNow& drive) const;

 private:
  double applied_V(const JointState& state, const DriveNow& drive, double bus_V) const;
  double quasi_static_A(const JointState& state, const DriveNow& drive, double bus_V) const;

  const actuator::Actuator& actuator_;
  actuator::Winding winding_;
  double inductance_H_ = 0.0;  ///< 0: quasi-static.
};

}  // namespace torquewright::simulation
