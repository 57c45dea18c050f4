// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/rollout/rollout.hpp"

namespace torquewright::identification {

/// How far the robot's simulation is from its log, with the actuators as stated and as refined.
struct SimulatedErrors {
  std::vector<std::string> joints;
  std::vector<Rollout> before,
      after;  ///< Lengths as in kWindows_s; after: empty, nothing was refined.
};

/// Lengths of the windows that are simulated: a stride's reaction, a stride, and 5 s, in which
/// errors that add up show. The figures that lead the report are those of the middle one.
inline const std::vector<double> kWindows_s = {0.25, 1.0, 5.0};
inline constexpr std::size_t kLeadingWindow = 1;
/// Most windows of each length that are simulated, evenly over the log.
inline constexpr std::size_t kMostWindows = 60;

}  // namespace torquewright::identification
