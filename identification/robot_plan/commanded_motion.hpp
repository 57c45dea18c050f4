// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// A wave of a commanded position, whose frequency grows or stays.
struct CommandedWave {
  double share = 1.0;  ///< Of the joint's reach; those of one joint add up to 1.
  double first_Hz = 1.0, last_Hz = 1.0;
  double phase_rad = 0.0;
};

/// What one joint is told: waves about a centre, which it never leaves by more than its reach.
struct JointCommand {
  double centre_rad = 0.0;
  double reach_rad = 0.0;
  std::vector<CommandedWave> waves;
};

/// What all joints are told in one run, faded in and out, so that it begins and ends at rest at the
/// centres.
struct CommandedMotion {
  std::string run;
  double duration_s = 0.0;
  std::vector<JointCommand> joints;  ///< In the rig's order.
};

/// Step of what is commanded.
inline constexpr double kCommandStep_s = 0.005;

/// The command of a joint, sampled every kCommandStep_s from 0 on.
std::vector<double> command_rad(const JointCommand& joint, double duration_s);

/// Gives each joint waves of its own: slow ones that move it far, which show friction and weight,
/// and fast ones that show inertia, of frequencies, shares and phases that are drawn.
void draw_waves(CommandedMotion& motion, std::mt19937_64& random);

/// Gives each joint the usual wave, for comparison: 0.1 to 5 Hz.
void sweep(CommandedMotion& motion);

/// Motions as a log whose joints are where they are told to be, to be simulated from its beginning.
Log log_of(const std::vector<CommandedMotion>& motions);

/// Commands as a CSV file with columns run, time_s and JOINT_commanded_position_rad.
std::string commands_csv(const std::vector<CommandedMotion>& motions,
                         const std::vector<std::string>& joints);

}  // namespace torquewright::identification
