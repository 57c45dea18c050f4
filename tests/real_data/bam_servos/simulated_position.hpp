// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/log/log.hpp"
#include "identification/rig/rig.hpp"
#include "simulation/excitation.hpp"

namespace torquewright::identification {

/// How a log's runs are simulated again. docs/derivations/simulation.md section 5.
struct PositionScoreOptions {
  /// A run is cut into windows of this length, each begun at the measured state; 0: the whole run
  /// from its first sample. Short windows ask for torque, long ones for everything that adds up.
  double window_s = 0.0;
  /// Drive by the logged position command through the servo's own controller, duty = clip(gain
  /// (command - position), -1, 1), instead of by the logged drive. A gain for each run of the log,
  /// in its order; empty: by the logged drive.
  std::vector<double> position_gain_1_rad;
  double longest_step_s = 1e-3;
};

/// One stretch of a log as the simulation needs it.
struct ReplayedRun {
  std::string name;
  simulation::Excitation excitation;
  std::vector<std::vector<double>> position_rad;  ///< Measured, by joint.
  std::vector<std::vector<double>> speed_rad_s;   ///< Measured, or by differences.
  std::vector<std::uint8_t> masked;
};

/// The runs of a log with what drives them: current, commanded torque, duty (times the logged bus),
/// winding voltage, whichever of these comes first; without any of them, or without positions,
/// throws io::SpecError. Where the drive is not enabled its winding is open: no current.
std::vector<ReplayedRun> replayed_runs(const Rig& rig, const Log& log,
                                       const PositionScoreOptions& options);

struct RunScore {
  std::string name;
  std::size_t samples = 0;
  double mean_absolute_rad = 0.0;
  double rms_rad = 0.0;
};

struct PositionScore {
  std::vector<RunScore> runs;
  double mean_absolute_rad = 0.0;  ///< Over all samples of the runs.
  double rms_rad = 0.0;
  bool is_finite = true;  ///< False: a simulation diverged.
};

/// Simulated against measured positions. What diverges scores pi for each sample that is left.
PositionScore position_score(const Rig& rig,
                             const std::vector<const actuator::Actuator*>& actuators,
                             const std::vector<ReplayedRun>& runs,
                             const PositionScoreOptions& options);

}  // namespace torquewright::identification
