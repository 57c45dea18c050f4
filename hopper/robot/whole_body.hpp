// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/tree_state.hpp"
#include "hopper/robot/robot.hpp"

namespace torquewright::hopper {

/// What one actuator does at an instant, at its output behind the gearbox.
struct DriveInstant {
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
  double acceleration_rad_s2 = 0.0;
  double load_torque_Nm = 0.0;  ///< Without what its own rotor takes: what the gears pass on.
  double torque_Nm = 0.0;       ///< With it.
};

/// A robot's bodies with its rotors apart: they turn as the drivetrains say, so that their inertia
/// couples joints and changes with the posture where mechanisms do.
/// docs/derivations/whole_body_check.md eqs. (2)-(5).
class WholeBody {
 public:
  explicit WholeBody(const Robot& robot);

  /// As dynamics::TreeState::set(). False where a mechanism does not reach the posture:
  /// unreached() names it, and only what needs no drivetrain may be asked for.
  [[nodiscard]] bool set(const dynamics::VectorIn& position, const dynamics::VectorIn& velocity);
  std::size_t unreached() const { return unreached_; }

  /// Its reflected inertias are those of no rotor of a drivetrain.
  dynamics::TreeState& state() { return state_; }
  const Robot& robot() const { return *robot_; }
  std::size_t drive_count() const { return drives_; }
  /// In the order of the drivetrains and their actuators.
  const std::string& drive_name(std::size_t drive) const;
  const actuator::Actuator& drive_actuator(std::size_t drive) const;
  double rotor_inertia_kg_m2(std::size_t drive) const { return rotors_kg_m2_[drive]; }

  /// Mass matrix, rotors included.
  void mass_matrix(dynamics::MatrixOut out);
  /// Forces for an acceleration, rotors included; per velocity, as dynamics::inverse_dynamics().
  void inverse_dynamics(const dynamics::VectorIn& acceleration, dynamics::VectorOut force);
  /// Adds what rotors take for an acceleration, at the joints.
  void add_rotors(const dynamics::VectorIn& acceleration, dynamics::VectorOut force) const;
  /// Each actuator's part of joint forces that include no rotor: load and total torque.
  void drives(const dynamics::VectorIn& acceleration, const dynamics::VectorIn& load_force,
              std::vector<DriveInstant>& out) const;
  /// Forces per velocity as torques at the actuators' outputs: J^-T of the joints' part.
  void at_actuators(const dynamics::VectorIn& force, dynamics::VectorOut torque_Nm) const;
  /// Changes of the joints' speeds as changes of the actuators' outputs' speeds.
  void speed_changes(const dynamics::VectorIn& change, dynamics::VectorOut at_actuators) const;

 private:
  struct Place {
    std::size_t drivetrain;
    std::size_t actuator;
  };
  SmallVector joints_of(const Drivetrain& drivetrain, const dynamics::VectorIn& values) const;
  SmallVector accelerations(std::size_t drivetrain, const dynamics::VectorIn& acceleration) const;

  const Robot* robot_;
  dynamics::TreeState state_;
  Eigen::VectorXd position_;
  std::size_t drives_ = 0;
  std::vector<Place> places_;
  std::vector<std::size_t> first_drive_;  ///< By drivetrain.
  std::vector<double> rotors_kg_m2_;      ///< By drive, at its output.
  std::vector<Transfer> transfers_;       ///< By drivetrain, as set.
  std::size_t unreached_ = 0;
};

}  // namespace torquewright::hopper
