// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <span>
#include <vector>

#include "dynamics/momentum.hpp"
#include "dynamics/tree_state.hpp"
#include "robot/mechanisms/linked_bodies.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// What one actuator does at an instant, at its output behind the gearbox.
struct DriveInstant {
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
  double acceleration_rad_s2 = 0.0;
  double load_torque_Nm = 0.0;  ///< Without what its own rotor takes: what the gears pass on.
  double torque_Nm = 0.0;       ///< With it.
  /// What its rotor takes for the turning of what carries it: the inertia of its own spin times
  /// that part of the carrier's acceleration (Joint::rotor_spin_kg_m2). Part of both torques.
  double carried_Nm = 0.0;

  /// Acceleration of the rotor in space, referred to the output: its inertia there times this is
  /// the torque that turns it.
  double rotor_acceleration_rad_s2(double rotor_kg_m2) const {
    return acceleration_rad_s2 + (rotor_kg_m2 > 0.0 ? carried_Nm / rotor_kg_m2 : 0.0);
  }
};

/// What cannot be as the joints stand, in words, and its joints by the bodies that they carry.
struct Unreached {
  std::string what;
  std::vector<std::size_t> joints;
};

/// Whether what its joints state of rotors stays in the tree: where they do not turn with one joint
/// at a constant ratio.
bool rotors_stay_in_tree(const Drivetrain& drivetrain);

/// Inertia of the rotor that turns with the drivetrain's one joint at a constant ratio, at the
/// actuator's output in kg m^2, as that joint has it. Requires rotors_in_tree, and that they do not
/// stay.
double rotor_in_tree_kg_m2(const Robot& robot, const Drivetrain& drivetrain);

/// A robot's bodies with its rotors apart: they turn as the drivetrains say, so that their inertia
/// couples joints and changes with the posture where mechanisms do.
/// docs/derivations/whole_body_check.md eqs. (2)-(4). Vectors per velocity (n x 1) as in
/// dynamics::TreeState; per drive (drive_count() x 1), in the order of the drivetrains and of their
/// actuators, in Nm and rad at the actuator's output behind its gearbox.
/// On any scalar for which dynamics/ stands; what needs a Jacobian's inverse in double alone.
template <typename T>
class WholeBodyOf {
 public:
  explicit WholeBodyOf(const Robot& robot);

  /// Sets position and velocity as dynamics::TreeState::set() does, and throws as that. False where
  /// a mechanism does not reach the posture: unreached() names it, and only what needs no
  /// drivetrain may be asked for.
  [[nodiscard]] bool set(const dynamics::VectorInOf<T>& position,
                         const dynamics::VectorInOf<T>& velocity);
  /// Returns what did not reach the posture last set: a mechanism, or links that follow.
  const Unreached& unreached() const { return unreached_; }

  /// Its reflected inertias are those of no rotor of a drivetrain. Links of loops are not in it.
  dynamics::TreeStateOf<T>& state() { return state_; }
  const dynamics::TreeStateOf<T>& state() const { return state_; }
  const Robot& robot() const { return *robot_; }
  std::size_t drive_count() const { return rotors_kg_m2_.size(); }
  /// N^2 J, the gears' and the crank's; 0 where what the joints state of it stays in the tree.
  double rotor_inertia_kg_m2(std::size_t drive) const { return rotors_kg_m2_[drive]; }
  /// The part of rotor_inertia_kg_m2() that turns before the first mesh: without the gears' own and
  /// the crank's. Where what the joints state stays in the tree, the actuator's N^2 J.
  double before_gears_kg_m2(std::size_t drive) const { return before_gears_kg_m2_[drive]; }

  /// (n x n), rotors included; eq. (2).
  void mass_matrix(dynamics::MatrixOutOf<T> out);
  /// Adds what rotors weigh (n x n): A^T I A at the joints of each drivetrain.
  void add_rotor_inertia(dynamics::MatrixOutOf<T> out) const;
  /// Forces for an acceleration, with rotors and the joints' dampers and springs, without their dry
  /// friction; per velocity, as dynamics::inverse_dynamics(); eq. (2).
  void inverse_dynamics(const dynamics::VectorInOf<T>& acceleration,
                        dynamics::VectorOutOf<T> force);
  /// The part of them that moves bodies, links of loops among them: without rotors, dampers and
  /// springs.
  void body_forces(const dynamics::VectorInOf<T>& acceleration, dynamics::VectorOutOf<T> force);
  /// Adds what dampers and springs take, those in loops among them.
  void add_dampers_and_springs(dynamics::VectorOutOf<T> force) const;
  /// Adds what dry friction takes of joints that move or begin to as the acceleration says, links'
  /// among them; docs/derivations/passive_forces.md eq. (2).
  void add_dry_friction(const dynamics::VectorIn& acceleration,
                        dynamics::VectorOut force) const requires std::same_as<T, double>;
  /// Writes what dry friction holds of needed forces, of joints that rest and stay so, links' among
  /// them; eq. (3).
  void held_by_friction(const dynamics::VectorIn& acceleration, const dynamics::VectorIn& needed,
                        dynamics::VectorOut held) const requires std::same_as<T, double>;
  /// Joints of the links of loops, behind those of state()'s tree; empty where none counts.
  std::span<const dynamics::Body> links() const;
  /// How fast links()[link] moves with each velocity (n x 1), in the posture that is set.
  dynamics::VectorX<T> link_motion(std::size_t link) const;
  /// Adds what links weigh (n x n), and the forces that they, their dampers and springs take where
  /// the velocities do not change (n x 1).
  void add_link_inertia(dynamics::MatrixOutOf<T> out) requires std::same_as<T, double>;
  void add_link_forces(dynamics::VectorOutOf<T> force) requires std::same_as<T, double>;
  /// Mass, momentum and inertia of all bodies, links of loops among them.
  dynamics::Centroid centroid() requires std::same_as<T, double>;
  /// Adds what rotors take for an acceleration, at the joints: A^T I (A a + A' v).
  void add_rotors(const dynamics::VectorInOf<T>& acceleration,
                  dynamics::VectorOutOf<T> force) const;
  /// Adds what torques of the drives (drive_count() x 1) are at the joints: A^T times them.
  void add_drive_torques(const dynamics::VectorInOf<T>& drive_Nm,
                         dynamics::VectorOutOf<T> force) const;
  /// Each actuator's part of joint forces that include no rotor: load and total torque, eqs. (3)
  /// and (4). Resizes `out`.
  void drives(const dynamics::VectorIn& acceleration, const dynamics::VectorIn& load_force,
              std::vector<DriveInstant>& out) const requires std::same_as<T, double>;
  /// Forces per velocity as torques at the actuators' outputs: A^-T of the joints' part.
  void at_actuators(const dynamics::VectorIn& force,
                    dynamics::VectorOut torque_Nm) const requires std::same_as<T, double>;
  /// What the turning of their carriers adds to the rotors' angular momenta, of a velocity or a
  /// change of one, in Nm s at the actuators' outputs.
  void carried_momenta(const dynamics::VectorIn& velocity,
                       dynamics::VectorOut at_actuators) const requires std::same_as<T, double>;
  /// Positions of the actuators' outputs in the posture that is set (drive_count() x 1), in rad.
  void drive_positions(dynamics::VectorOut at_actuators) const requires std::same_as<T, double>;
  /// Changes of the joints' speeds as changes of the actuators' outputs' speeds: A times them.
  void speed_changes(const dynamics::VectorIn& change,
                     dynamics::VectorOut at_actuators) const requires std::same_as<T, double>;

 private:
  bool set_drivetrain(std::size_t drivetrain);
  bool set_loop(std::size_t drivetrain, std::size_t loop);
  bool set_follower(std::size_t loop);
  SmallVectorOf<T> joints_of(const Drivetrain& drivetrain,
                             const dynamics::VectorInOf<T>& values) const;
  SmallVectorOf<T> positions_of(const Drivetrain& drivetrain) const;
  SmallVectorOf<T> accelerations(std::size_t drivetrain,
                                 const dynamics::VectorInOf<T>& acceleration) const;
  /// Angular accelerations of the bodies for an acceleration, in the world's axes; without
  /// velocity products their angular velocities for a velocity.
  std::vector<Eigen::Vector3d> turning(const dynamics::VectorIn& acceleration,
                                       bool has_products) const requires std::same_as<T, double>;
  /// Returns what rotors' own spins take where their carriers turn so, by velocity: torques for
  /// accelerations, momenta for velocities.
  Eigen::VectorXd carried(
      const std::vector<Eigen::Vector3d>& turning) const requires std::same_as<T, double>;
  /// Adds torques of a drivetrain's joints to forces per velocity.
  void add_at_joints(const Drivetrain& drivetrain, const SmallVectorOf<T>& torque_Nm,
                     dynamics::VectorOutOf<T>& force) const;

  const Robot* robot_;
  dynamics::TreeStateOf<T> state_;
  LinkedBodiesOf<T> linked_;
  std::vector<FollowedOf<T>> followed_;          ///< By loop of it, of drivetrains first.
  std::vector<std::size_t> linked_drivetrains_;  ///< By loop of it, of drivetrains alone.
  std::vector<std::size_t> first_drive_;         ///< By drivetrain.
  std::vector<double> rotors_kg_m2_;             ///< By drive, at its output.
  std::vector<double> before_gears_kg_m2_;
  std::vector<TransferOf<T>> transfers_;  ///< By drivetrain, as set.
  Unreached unreached_;
};
using WholeBody = WholeBodyOf<double>;

}  // namespace torquewright::hopper
