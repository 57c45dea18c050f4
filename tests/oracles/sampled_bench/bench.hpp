// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/draw.hpp"
#include "tests/oracles/sampled_bench/laws.hpp"
#include "tests/oracles/sampled_bench/signal.hpp"

namespace torquewright::oracles::sampled {

enum Channel : std::size_t {
  kOutputPosition,
  kOutputVelocity,
  kMotorPosition,
  kMotorVelocity,
  kCurrent,
  kDuty,
  kWindingVoltage,
  kBusVoltage,
  kTorque,
  kCommandedTorque,
  kCommandedPosition,
  kWindingTemperature,
  kCaseTemperature,
  kChannels
};

using Row = std::array<double, kChannels>;

/// How one channel comes into the log.
struct Sensor {
  bool is_logged = false;
  double noise = 0.0;       ///< White, rms per sample, after the anti-aliasing filter.
  double resolution = 0.0;  ///< Of an encoder or converter; 0: none.
  double delay_s = 0.0;     ///< An undeclared fault.
  double offset = 0.0;      ///< An undeclared fault.
  double scale = 1.0;       ///< An undeclared fault.
};

/// Faults of sensors that no effect describes. Neutral as constructed.
struct SensorOddities {
  double eccentricity_rad = 0.0, eccentricity_phase_rad = 0.0;  ///< Of the output's encoder.
  double interpolation_rad = 0.0, interpolation_lines = 256.0;  ///< Of the output's encoder.
  double negative_gain = 1.0;                                   ///< Of the current's sensor.
  double dead_band_A = 0.0;
  double torque_drift_1_s = 0.0;  ///< In Nm per second since the log began.
  double hum = 0.0, hum_hz = 0.0;
  Channel hum_channel = kTorque;
};

/// From the machine to the file: filter, sample and hold, converter, clock.
struct SamplingChain {
  std::array<Sensor, kChannels> sensors;
  SensorOddities odd;
  int sample_steps = 20;   ///< Integration steps between two samples.
  double filter_hz = 0.0;  ///< First order, before the converters of analogue channels; 0: none.
  double stamp_jitter_s = 0.0;  ///< Of time stamps, rms.
  double clock_error = 0.0;     ///< Largest share by which a run's clock is fast or slow.
  double missing_share = 0.0;   ///< Of rows.
};

/// One run: what the bench does.
struct RunPlan {
  Signal reference;  ///< Speed of the output, or its position.
  bool is_position = false;
  Signal other;  ///< Imposed speed: current asked for (A). Brake: its torque (Nm).
  double duration_s = 8.0;
  double start_winding_K = kReference_K;
  double mass_factor = 1.0;  ///< Of the load, in this run only: an oddity.
};

struct RunLog {
  std::vector<Instant> truth;
  std::vector<Row> ideal;     ///< Without any sensor.
  std::vector<Row> measured;  ///< With noise and resolution.
  std::vector<double> stamp_s;
};

inline constexpr double kStep_s = 5e-5;
inline constexpr int kControlSteps = 10;  ///< Commands are a staircase of 0.5 ms.

/// Values of all channels at an instant, as flawless sensors would show them.
Row ideal_row(const Plant& plant, const Instant& at);
RunLog run_bench(const Plant& plant, const Laws& laws, const SamplingChain& chain,
                 const RunPlan& plan, double begins_s, Draw& draw);

}  // namespace torquewright::oracles::sampled
