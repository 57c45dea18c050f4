// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// The scatter of what was measured in steady states about a surface that is smooth over the
/// states: over speed, drive (current, torque or voltage), position and temperature, as far as they
/// were logged and change. Directions of the motion are surfaces of their own.
class Scatter {
 public:
  Scatter(const Log& log, std::size_t joint);

  /// The measured channels that are not coordinates of the state: torque sensors, voltages.
  const std::vector<Quantity>& dependent() const { return dependent_; }

  /// Standard deviation of the channel: the median magnitude, times 1.4826, of its distances from
  /// the plane through the nearest other states, each over what white noise of 1 makes of it. A
  /// curved surface adds to it; of nearnesses that each hold one coordinate closest, the one that
  /// scatters least counts. 0 where there are too few states.
  double level(Quantity quantity) const;

 private:
  struct State {
    std::vector<double> at;  ///< Coordinates in parts of their greatest, speed first where logged.
  };
  double distance_from_plane(std::size_t state, const std::vector<double>& values,
                             std::size_t curved) const;

  std::vector<State> states_;
  std::vector<Quantity> coordinates_, dependent_;
  std::vector<std::vector<double>> values_;  ///< Of the dependent channels, by state.
};

}  // namespace torquewright::identification
