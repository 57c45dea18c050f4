// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/rollout/rollout.hpp"

namespace torquewright::identification {

/// How far a robot's simulation is from its log, over windows of several lengths.
struct RobotErrors {
  std::vector<Rollout> windows;  ///< Lengths as in kWindows_s.
  /// Whole runs (of long ones the first kLongestWhole_s, and so on), after the first
  /// kSettling_s: the figures that lead the report.
  Rollout whole;
};

/// The errors with the drives as stated and as refined.
struct SimulatedErrors {
  std::vector<std::string> joints;
  RobotErrors before, after;
  bool is_refined = false;  ///< False: `after` is empty.
};

/// Lengths of the short windows: a stride's reaction, and a stride.
inline const std::vector<double> kWindows_s = {0.25, 1.0};
inline constexpr double kLongestWhole_s = 120.0;
inline constexpr double kSettling_s = 0.5;

/// Simulates the windows of all lengths. Requires can_roll_out().
RobotErrors robot_errors(const Log& log, const RobotModel& model,
                         const std::function<void(double share)>& on_progress = {});

/// The errors on runs that no fit saw, or, where none was held out, on the fitted ones.
const RolloutError& judged(const Rollout& rollout);

}  // namespace torquewright::identification
