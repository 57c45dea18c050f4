// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/bench_log/machine.hpp"
#include "tests/oracles/bench_log/plant.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace torquewright::oracles {

/// What stands between the truth and the log, noise apart. Defaults change nothing.
struct LogFaults {
  std::string late_channel;
  double late_s = 0.0;
  double torque_offset = 0.0, current_offset_A = 0.0;
  double velocity_scale = 1.0, velocity_late_s = 0.0;
  // Outside the library.
  double current_dead_zone_A = 0.0;    ///< Half its width.
  double current_negative_gain = 1.0;  ///< The sensor's gain for negative currents.
  double hysteresis_Nm = 0.0, hysteresis_span_Nm = 1.0;  ///< Of the torque sensor.
};

struct Channel {
  std::string quantity;
  std::string column;  ///< Its name in the log.
  double sigma = 0.0;
  double resolution = 0.0;
  double column_scale = 1.0;  ///< quantity = scale * column.
};

/// What the documents say about the load.
struct StatedLoad {
  double mass_kg = 0.0, length_m = 0.0, inertia_kg_m2 = 0.0;
};

/// A drive on a rig, what is done with it, and what is measured.
struct Bench {
  Machine nominal;  ///< With the load as stated and the declared effects: what the documents say.
  Machine truth;
  LogFaults faults;
  StatedLoad stated;
  std::vector<RunPlan> runs;
  std::vector<Channel> channels;
  int ticks_per_sample = 2;
  std::vector<std::string> uncertain;
  bool has_ignored_column = false;
  bool one_file = true;
};

/// True channels of one run at its samples, faults included, noise not.
struct CleanRun {
  std::vector<double> time_s;
  std::vector<std::vector<double>> columns;  ///< Of Bench::channels.
  std::vector<double> torque_residual, kinematic_residual, electrical_residual, bus_residual,
      velocity_residual;  ///< What the nominal model leaves of the clean channels.
};

CleanRun measure(const Bench& bench, const Trace& trace);

/// Adds noise and rounds to the resolution.
LogRun with_noise(const Bench& bench, const CleanRun& run, const std::string& name, Chance& chance);

double sample_rate_Hz(const Bench& bench);

}  // namespace torquewright::oracles
