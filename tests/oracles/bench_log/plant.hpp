// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/bench_log/machine.hpp"
#include "tests/oracles/bench_log/motion.hpp"

namespace torquewright::oracles {

/// What is done in one run. All knots are of one length.
struct RunPlan {
  std::string name;
  Knots speed_rad_s;   ///< Dynamometer: imposed on the output.
  Knots position_rad;  ///< Other loads: what a position controller follows. Empty: open loop.
  Knots current_A;     ///< Commanded; on other loads what is added to the controller's.
  Knots voltage_V;     ///< Not empty: the drive is given a voltage, the current follows.
  double controller_Nm_rad = 0.0, controller_Nm_s_rad = 0.0;
  double start_rad = 0.0, start_rad_s = 0.0;
  double winding_K = 298.15, case_K = 298.15;  ///< At the start.

  std::size_t knot_count() const;
};

/// The physical truth on the knots of a run, without sensors.
struct Trace {
  std::vector<double> position_rad, speed_rad_s, acceleration_rad_s2;  ///< Output.
  std::vector<double> motor_position_rad, motor_speed_rad_s;           ///< Rotor.
  std::vector<double> current_A, torque_Nm;  ///< Torque: what the actuator exerts on the load.
  std::vector<double> voltage_V;             ///< Over the winding, as commanded.
  std::vector<double> bus_V, winding_K, case_K;
};

/// Work since the run's start [J]: put in by the motor's torque, lost in friction and gear (these
/// three where there is one inertia only); and what is stored at the end less at the start.
struct EnergyAccount {
  double motor_J = 0.0, friction_J = 0.0, gear_J = 0.0;
  double stored_J = 0.0;
};

/// Integrates the run. Sticking is exact: at rest the drive stays at rest until the torque exceeds
/// what friction holds; a reversal ends in a stop at its own instant, not at a step's end.
/// `substeps` per tick; 0 chooses (20 with two positions, 10 otherwise).
Trace simulate(const Machine& machine, const RunPlan& plan, int substeps = 0,
               EnergyAccount* account = nullptr);

}  // namespace torquewright::oracles
