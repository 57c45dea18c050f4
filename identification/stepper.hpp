// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/joint_model.hpp"
#include "identification/load_dynamics.hpp"

namespace torquewright::identification {

/// The motion of all joints of a rig at an instant.
struct RigState {
  std::vector<JointState> joints;
};

/// Accelerations at an instant and what causes them.
struct RigMotion {
  std::vector<JointForces> forces;
  Eigen::VectorXd acceleration_rad_s2;        ///< Of the outputs.
  Eigen::VectorXd motor_acceleration_rad_s2;  ///< Of the motors, at the output.
  Eigen::VectorXd torque_Nm;                  ///< On the load.
};

/// Moves the joints of a rig through time. docs/derivations/simulation.md section 3.
class Stepper {
 public:
  Stepper(const LoadDynamics& load, const std::vector<JointModel>& models);

  /// Directions of motion: of a joint at rest that in which it starts; 0: friction holds it.
  std::vector<double> directions(const RigState& state, const std::vector<DriveNow>& drive);

  /// With those directions. Accelerations of imposed outputs stand in `imposed_rad_s2`.
  RigMotion motion(const RigState& state, const std::vector<double>& directions,
                   const std::vector<DriveNow>& drive, const Eigen::VectorXd* imposed_rad_s2);

  /// One step with everything that has a rate of its own held; stops and starts within it are
  /// found.
  void advance(RigState& state, const std::vector<DriveNow>& drive, double step_s,
               WorkAccount& work);

  /// The same where the outputs' motion is imposed: `middle` and `end` hold the output's motion
  /// there. Only the motors of elastic trains are integrated.
  void advance_imposed(RigState& state, const std::vector<DriveNow>& drive, double step_s,
                       const JointState& middle, const JointState& end, double acceleration_rad_s2,
                       WorkAccount& work);

 private:
  bool release_one(const RigState& state, const std::vector<DriveNow>& drive,
                   std::vector<double>& directions);
  void solve(const RigState& state, const std::vector<double>& directions, RigMotion& motion);
  void account(const RigState& at, const RigMotion& motion, double step_s, WorkAccount& work) const;
  void set_positions(const RigState& state);

  const LoadDynamics& load_;
  const std::vector<JointModel>& models_;
  Eigen::VectorXd position_, speed_, bias_;
  Eigen::MatrixXd mass_;
};

}  // namespace torquewright::identification
