// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/engines/engine.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::test {

/// Where a robot is and how it moves, and the joint forces (per velocity) that belong to it.
struct EngineState {
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd force;
};

/// specs/robot/hopper.json
hopper::Robot hopper_robot();

/// Its sole flat on the ground z = 0, at rest, the centre of mass above the sole, and the torques
/// that hold it so (statics).
EngineState standing(const hopper::Robot& hopper, double knee_rad);

/// High above the ground, all joints and the base in motion, constant torques of the drives.
EngineState flying(const hopper::Robot& hopper);

/// The hand-made flip's (specs/trajectory/hopper_flip.csv) last row before touch-down, its lowest
/// point on the ground z = 0; no torque.
EngineState touching_down(const hopper::Robot& hopper);

/// The same leg turned in the sagittal plane about the sole, so that it lands on its heel.
EngineState landing_on_heel(const hopper::Robot& hopper);

/// The state's force and joint springs and dampers about the state.
Eigen::VectorXd holding_force(const hopper::Engine& engine, const EngineState& about);
/// The same, into a force that has its size.
void hold(const hopper::Engine& engine, const EngineState& about, Eigen::VectorXd& force);

/// Springs' stiffness and damping of holding_force(), Nm/rad and Nm s/rad.
inline constexpr double kSpring_Nm_rad = 800.0;
inline constexpr double kDamper_Nm_s_rad = 20.0;

/// Kinetic and potential, of bodies and rotors.
double energy_J(hopper::WholeBody& body, const Eigen::VectorXd& position,
                const Eigen::VectorXd& velocity);

/// About the centre of mass; rotors carry none.
Eigen::Vector3d angular_momentum_Nm_s(hopper::WholeBody& body, const Eigen::VectorXd& position,
                                      const Eigen::VectorXd& velocity);

}  // namespace torquewright::test
