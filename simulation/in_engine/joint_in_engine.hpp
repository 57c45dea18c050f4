// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "actuator/motor/actuator.hpp"
#include "simulation/excitation.hpp"
#include "simulation/joint/joint_state.hpp"

namespace torquewright::simulation {

/// How an engine moves the output of a joint during one of its steps: evenly, from a position.
struct OutputStep {
  double position_rad = 0.0;  ///< At which the step begins.
  double speed_rad_s = 0.0;
  double step_s = 0.0;
};

/// One actuator, by the laws of simulation/joint, whose output an engine of rigid bodies moves. It
/// keeps what has a motion or a rate of its own: the lag's torque, the bristles of friction, and
/// the rotor where the train between it and the output is elastic. The rotor of a rigid train is
/// part of the engine's bodies, and the torque is what accelerates rotor and load; an elastic
/// train's rotor is not, and the torque is the load's alone.
///
/// The laws are asked at the output's angle in the middle of the step, and states advance by half
/// steps around it (docs/derivations/replay_drives.md). Requires that the actuator outlives it.
class JointInEngine {
 public:
  /// `options.motor_inertia_kg_m2` moves the rotor of an elastic train;
  /// `options.longest_step_s` bounds the parts into which a step is divided for it.
  JointInEngine(const actuator::Actuator& actuator, const SimulationOptions& options);
  JointInEngine(const JointInEngine& other);
  JointInEngine& operator=(const JointInEngine& other);
  JointInEngine(JointInEngine&&) noexcept;
  JointInEngine& operator=(JointInEngine&&) noexcept;
  ~JointInEngine();

  /// Whether the motor has a position of its own: backlash or compliance, and a rotor that weighs.
  bool is_elastic() const;

  /// Forgets what was: at the next step the states are where they would settle under its drive.
  void start();

  /// In rad/s at the output: the motor's own where it has one, else the output's.
  double motor_speed_rad_s(double output_speed_rad_s) const;

  /// The torque that acts during the step, in Nm at the output, as its mean. `drive.motor_Nm` is
  /// what the motor is to make, `direction` (-1 or 1) that of a rigid train's motion at rest.
  double advance(const OutputStep& output, const DriveNow& drive, double direction,
                 double winding_K);

  /// The joint as the last step left it.
  const JointState& state() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace torquewright::simulation
