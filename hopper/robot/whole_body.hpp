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

/// Whether what its joints state of rotors stays in the tree: where they do not turn with one joint
/// at a constant ratio.
bool rotors_stay_in_tree(const Drivetrain& drivetrain);

/// A robot's bodies with its rotors apart: they turn as the drivetrains say, so that their inertia
/// couples joints and changes with the posture where mechanisms do.
/// docs/derivations/whole_body_check.md eqs. (2)-(4). Vectors per velocity (n x 1) as in
/// dynamics::TreeState; per drive (drive_count() x 1), in the order of the drivetrains and of their
/// actuators, in Nm and rad at the actuator's output behind its gearbox.
class WholeBody {
 public:
  explicit WholeBody(const Robot& robot);

  /// As dynamics::TreeState::set(), and throws as that. False where a mechanism does not reach the
  /// posture: unreached() names it, and only what needs no drivetrain may be asked for.
  [[nodiscard]] bool set(const dynamics::VectorIn& position, const dynamics::VectorIn& velocity);
  /// Index of a drivetrain.
  std::size_t unreached() const { return unreached_; }

  /// Its reflected inertias are those of no rotor of a drivetrain.
  dynamics::TreeState& state() { return state_; }
  const Robot& robot() const { return *robot_; }
  std::size_t drive_count() const { return rotors_kg_m2_.size(); }
  /// N^2 J, the gears' and the crank's; 0 where what the joints state of it stays in the tree.
  double rotor_inertia_kg_m2(std::size_t drive) const { return rotors_kg_m2_[drive]; }
  /// Of that what turns before the first mesh: without the gears' own and the crank's. Where what
  /// the joints state stays in the tree, the actuator's N^2 J.
  double before_gears_kg_m2(std::size_t drive) const { return before_gears_kg_m2_[drive]; }

  /// (n x n), rotors included; eq. (2).
  void mass_matrix(dynamics::MatrixOut out);
  /// Adds what rotors weigh (n x n): A^T I A at the joints of each drivetrain.
  void add_rotor_inertia(dynamics::MatrixOut out) const;
  /// Forces for an acceleration, rotors included; per velocity, as dynamics::inverse_dynamics();
  /// eq. (2).
  void inverse_dynamics(const dynamics::VectorIn& acceleration, dynamics::VectorOut force);
  /// Adds what rotors take for an acceleration, at the joints: A^T I (A a + A' v).
  void add_rotors(const dynamics::VectorIn& acceleration, dynamics::VectorOut force) const;
  /// Each actuator's part of joint forces that include no rotor: load and total torque, eqs. (3)
  /// and (4). Resizes `out`.
  void drives(const dynamics::VectorIn& acceleration, const dynamics::VectorIn& load_force,
              std::vector<DriveInstant>& out) const;
  /// Forces per velocity as torques at the actuators' outputs: A^-T of the joints' part.
  void at_actuators(const dynamics::VectorIn& force, dynamics::VectorOut torque_Nm) const;
  /// Changes of the joints' speeds as changes of the actuators' outputs' speeds: A times them.
  void speed_changes(const dynamics::VectorIn& change, dynamics::VectorOut at_actuators) const;
  /// Forces per velocity that torques at the actuators' outputs make: A^T times them. Zero at the
  /// base and at joints without a drive.
  void joint_forces(const dynamics::VectorIn& at_actuators_Nm, dynamics::VectorOut force) const;

 private:
  SmallVector joints_of(const Drivetrain& drivetrain, const dynamics::VectorIn& values) const;
  SmallVector accelerations(std::size_t drivetrain, const dynamics::VectorIn& acceleration) const;

  const Robot* robot_;
  dynamics::TreeState state_;
  Eigen::VectorXd position_;
  std::vector<std::size_t> first_drive_;  ///< By drivetrain.
  std::vector<double> rotors_kg_m2_;      ///< By drive, at its output.
  std::vector<double> before_gears_kg_m2_;
  std::vector<Transfer> transfers_;  ///< By drivetrain, as set.
  std::size_t unreached_ = 0;
};

}  // namespace torquewright::hopper
