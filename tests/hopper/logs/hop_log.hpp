// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/check/hopper_check.hpp"
#include "tests/hopper/logs/simulated_hop.hpp"

namespace torquewright::test {

/// What a log of a hop holds beside positions.
struct LogContent {
  int rate_Hz = 1000;
  bool velocities = true;
  bool accelerations = false;
  bool forces = false;
  bool flags = false;
  double noise = 0.0;  ///< 1: sensor_noise(); in proportion.
  bool late = false;   ///< Accelerations, forces, flags and torques are of the row before.
  bool torques = false;
};

/// Standard deviations of one unit of noise.
struct SensorNoise {
  double position = 1e-4;     ///< rad, m
  double velocity = 5e-3;     ///< rad/s, m/s
  double acceleration = 0.1;  ///< rad/s^2, m/s^2
  double force_share = 2e-3;  ///< Of the greatest force; of those that are not 0.
};

std::string words_of(const LogContent& content);

/// Every so many of the hop's samples; the same content has the same noise.
hopper::Motion log_of(const PublicHopper& hopper, const SimulatedHop& hop,
                      const LogContent& content);

// What the check is asked for, relative.
constexpr double kTorqueGoal = 0.03;
constexpr double kMomentumGoal = 1e-3;
constexpr double kImpulseGoal = 0.05;

/// How far what the check says is from what MuJoCo computed at its fine step, relative.
struct HopErrors {
  double peak = 0.0;  ///< Torque, the worst of joints that matter (a tenth of the greatest).
  double rms = 0.0;   ///< Likewise.
  double flight_momentum = 0.0;  ///< CAM of the flight.
  double momentum = 0.0;         ///< CAM at any sample, of its greatest.
  double impulse = 0.0;          ///< Of the ground, upwards, in the 60 ms from the touch-down on.
  double doubt = 0.0;            ///< Widest range that the check states for a peak, over the peak.
  bool is_known = true;  ///< Each peak is within the goal, or in the range that the check states.
};

HopErrors errors_of(const SimulatedHop& hop, const hopper::Motion& log,
                    const hopper::HopperReport& report);

}  // namespace torquewright::test
