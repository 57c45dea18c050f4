// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/replay/replay.hpp"

namespace torquewright::identification {

/// Windows of a log with what is needed to judge an actuator by them.
struct ReplayCase {
  const Replay& replay;
  std::vector<ReplayWindow> windows;

  /// Mean squared position error of each window, in rad^2.
  std::vector<double> losses(const actuator::Actuator& actuator,
                             const std::vector<std::size_t>& which) const;
  /// Indices into `windows` of those held out, or of the others.
  std::vector<std::size_t> chosen(bool held_out) const;
};

/// Root of the mean of the windows' mean squares; 0 for no windows.
double rms_of_losses(const std::vector<double>& losses);

}  // namespace torquewright::identification
