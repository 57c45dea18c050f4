// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/stepper/work_account.hpp"

namespace torquewright::simulation {

/// Motion and torque of one joint at the times of the excitation, without noise.
struct JointTrace {
  std::vector<double> position_rad, speed_rad_s, acceleration_rad_s2;  ///< Motion of the output.
  std::vector<double> motor_position_rad, motor_speed_rad_s;           ///< Motion of the rotor.
  std::vector<double> current_A, voltage_V, bus_V;
  std::vector<double> torque_Nm;  ///< Torque on the load.
  std::vector<double> winding_K, case_K;
};

struct SimulatedRun {
  std::vector<JointTrace> joints;
  WorkAccount work;
  double step_s = 0.0;    ///< Longest step that was taken.
  bool is_finite = true;  ///< False: the motion diverged; the traces end where it did.
};

}  // namespace torquewright::simulation
