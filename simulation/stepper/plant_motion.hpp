// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/joint/joint_model.hpp"

namespace torquewright::simulation {

/// States of all joints of a plant at an instant.
struct PlantState {
  std::vector<JointState> joints;
};

/// Accelerations of all joints at an instant and their causes; vectors are (n x 1).
struct PlantMotion {
  std::vector<JointForces> forces;
  Eigen::VectorXd acceleration_rad_s2;        ///< Acceleration of the outputs.
  Eigen::VectorXd motor_acceleration_rad_s2;  ///< Acceleration of the motors, at the output.
  Eigen::VectorXd torque_Nm;                  ///< Torque on the load.
};

}  // namespace torquewright::simulation
