// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/bench_log/bench.hpp"

namespace torquewright::oracles {

/// What an experiment needs of its bench.
struct Wishes {
  Load::Type rig = Load::Type::kDynamometer;
  bool declares_friction = false;  ///< Coulomb and viscous friction stand in the nominal actuator.
  bool warm_runs = false;          ///< Runs start cold and warm in turn; the temperature is logged.
  bool slow = false;               ///< Slow motion: ripple of high order stays in the band.
  bool fast_current = false;       ///< Current up to 8 Hz: a lag is more than a delay.
  bool two_positions = false;      ///< The motor's position is logged too.
  bool voltages = false;           ///< Winding voltage, bus voltage and duty are logged.
  bool velocity = false;           ///< The output's velocity is logged for certain.
  bool integer_ratio = false;
  int runs = 6;
  double run_s = 15.0;
};

/// The value to so many significant digits, as a document would state it.
double rounded(double value, int digits = 3);

/// Peak torque of the drive, N Kt i_peak [N m].
double peak_torque_Nm(const Machine& machine);

/// A bench without faults: truth and nominal are alike. Motions and currents are mixed: multisines,
/// slow triangles, chirps and steps, all four quadrants.
Bench draw_bench(const Wishes& wishes, Chance& chance);

/// The parts, for benches that are poor on purpose.
void draw_machine(Bench& bench, const Wishes& wishes, Chance& chance);
void add_channels(Bench& bench, const Wishes& wishes, Chance& chance);
void set_temperatures(Bench& bench, const Wishes& wishes);
/// Gains of a position controller for the load.
void set_controller(const Machine& machine, RunPlan& plan);

}  // namespace torquewright::oracles
