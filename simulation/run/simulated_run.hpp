// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/stepper/work_account.hpp"

namespace torquewright::simulation {

/// The truth of one joint at the times of the excitation.
struct JointTrace {
  std::vector<double> position_rad, speed_rad_s, acceleration_rad_s2;  ///< Output.
  std::vector<double> motor_position_rad, motor_speed_rad_s;           ///< Rotor.
  std::vector<double> current_A, voltage_V, bus_V;
  std::vector<double> torque_Nm;  ///< On the load.
  std::vector<double> winding_K, case_K;
};

struct SimulatedRun {
  std::vector<JointTrace> joints;
  WorkAccount work;
  double step_s = 0.0;    ///< Longest that was taken.
  bool is_finite = true;  ///< False: it diverged; the traces end where it did.
};

}  // namespace torquewright::simulation
