// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/replay/replay.hpp"

namespace torquewright::identification {

/// Windows of a log and what they are judged by.
struct ReplayCase {
  const Replay& replay;
  std::vector<ReplayWindow> windows;

  /// Mean squared error of each window, in rad2.
  std::vector<double> losses(const actuator::Actuator& actuator,
                             const std::vector<std::size_t>& which) const;
  /// Indices into `windows`.
  std::vector<std::size_t> chosen(bool held_out) const;
};

/// The root of the mean of windows' mean squares; 0 of none.
double rms_of_losses(const std::vector<double>& losses);

}  // namespace torquewright::identification
