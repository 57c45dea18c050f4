// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/joint/joint_model.hpp"

namespace torquewright::simulation {

/// The motion of all joints of a plant at an instant.
struct PlantState {
  std::vector<JointState> joints;
};

/// Accelerations at an instant and what causes them, joint by joint: vectors are (n x 1).
struct PlantMotion {
  std::vector<JointForces> forces;
  Eigen::VectorXd acceleration_rad_s2;        ///< Of the outputs.
  Eigen::VectorXd motor_acceleration_rad_s2;  ///< Of the motors, at the output.
  Eigen::VectorXd torque_Nm;                  ///< On the load.
};

}  // namespace torquewright::simulation
