// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/robot_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "io/faults/refusal.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

constexpr double kStill_rad = 3e-3;  ///< Two counts of an encoder of 12 bits.
/// Of the slope of commands over positions about that of degrees: a loop's own lag is less.
constexpr double kAboutDegrees = 1.4;

/// Covariance of commands and positions over the variance of positions, of all runs.
double slope_of_commands(const Log& log, std::size_t joint) {
  double both = 0.0, square = 0.0;
  for (const Run& run : log.runs) {
    const std::vector<double>& position = run.joints[joint][Quantity::kOutputPosition];
    const std::vector<double>& command = run.joints[joint][Quantity::kCommandedPosition];
    if (position.empty() || command.size() != position.size()) continue;
    double mean = 0.0, mean_command = 0.0;
    for (const double each : position) mean += each / static_cast<double>(position.size());
    for (const double each : command) mean_command += each / static_cast<double>(command.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
      both += (position[i] - mean) * (command[i] - mean_command);
      square += (position[i] - mean) * (position[i] - mean);
    }
  }
  return square > 0.0 ? both / square : 0.0;
}

}  // namespace

std::vector<bool> moving_joints(const Rig& rig, const Log& log) {
  std::vector<bool> moves(rig.joints.size(), rig.load.type != LoadType::kRobot);
  for (const Run& run : log.runs) {
    for (std::size_t joint = 0; joint < moves.size(); ++joint) {
      const std::vector<double>& position = run.joints[joint][Quantity::kOutputPosition];
      if (position.empty()) {
        moves[joint] = true;
        continue;
      }
      const auto [least, most] = std::minmax_element(position.begin(), position.end());
      moves[joint] = moves[joint] || *most - *least > kStill_rad;
    }
  }
  return moves;
}

void check_robot_motion(const Rig& rig, Log& log) {
  if (rig.load.type != LoadType::kRobot) return;
  const std::vector<bool> moves = moving_joints(rig, log);
  std::vector<std::string> still;
  for (std::size_t joint = 0; joint < moves.size(); ++joint) {
    if (!moves[joint]) {
      still.push_back(rig.joints[joint]);
      continue;
    }
    const double slope = slope_of_commands(log, joint) * std::numbers::pi / 180.0;
    if (slope < 1.0 / kAboutDegrees || slope > kAboutDegrees) continue;
    io::refuse(rig.file, fmt::format("commanded_position_rad of {} changes {:.0f} times as much as "
                                     "its position: they are degrees; say \"unit\": \"deg\" of the "
                                     "column",
                                     rig.joints[joint], slope * 180.0 / std::numbers::pi));
  }
  if (still.empty()) return;
  log.findings.push_back(
      {Weight::kWarning, fmt::format("{} never move{}: what does not move is not judged",
                                     io::listed(still), still.size() == 1 ? "s" : "")});
}

}  // namespace torquewright::identification
