// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "actuator/motor/actuator.hpp"
#include "simulation/excitation.hpp"
#include "simulation/joint/joint_state.hpp"

namespace torquewright::simulation {

/// How an engine moves the output of a joint during one of its steps: at constant speed, from a
/// position.
struct OutputStep {
  double position_rad = 0.0;  ///< Position at which the step begins.
  double speed_rad_s = 0.0;
  double step_s = 0.0;
};

/// One actuator, by the laws of simulation/joint, whose output an engine of rigid bodies moves. It
/// keeps the states with a rate of their own: the lag's torque, the bristles of friction, and the
/// rotor where the train between it and the output is elastic. The rotor of a rigid train is part
/// of the engine's bodies, so the torque accelerates rotor and load; the rotor of an elastic train
/// is not, and the torque is that on the load. Laws are evaluated at the output's angle in the
/// middle of the step, and states advance by half steps around it
/// (docs/derivations/replay_drives.md). Requires that the actuator outlives it.
class JointInEngine {
 public:
  /// `options.motor_inertia_kg_m2` is the rotor's inertia in an elastic train;
  /// `options.longest_step_s` bounds the parts into which a step is divided for it.
  JointInEngine(const actuator::Actuator& actuator, const SimulationOptions& options);
  JointInEngine(const JointInEngine& other);
  JointInEngine& operator=(const JointInEngine& other);
  JointInEngine(JointInEngine&&) noexcept;
  JointInEngine& operator=(JointInEngine&&) noexcept;
  ~JointInEngine();

  /// Whether the motor has a position of its own: backlash or compliance, and a rotor with inertia.
  bool is_elastic() const;

  /// Resets the states: at the next step they are where they would settle under its drive.
  void start();

  /// Speed in rad/s at the output: the motor's own where it has one, else the output's.
  double motor_speed_rad_s(double output_speed_rad_s) const;

  /// Advances by a step and returns the mean torque that acts during it, in Nm at the output.
  /// `drive.motor_Nm` is the torque that the motor is to make, `direction` (-1 or 1) the direction
  /// of a rigid train's motion at rest.
  double advance(const OutputStep& output, const DriveNow& drive, double direction,
                 double winding_K);

  /// State of the joint after the last step.
  const JointState& state() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace torquewright::simulation
