// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "identification/preparation/preparation.hpp"
#include "simulation/plant.hpp"

namespace torquewright::identification {

/// A piece of a stretch that is simulated from the state that was measured at its first sample.
struct ReplayWindow {
  std::size_t stretch = 0;  ///< Index into the signals.
  std::size_t first = 0, last = 0;
  bool is_held_out = false;
  bool rests = false;  ///< The output rests in a part of it.
};

/// Returns pieces of one second without a masked sample, at most `most`, evenly spread over the
/// log. `held_out` (by Log::runs) chooses the runs.
std::vector<ReplayWindow> replay_windows(const std::vector<Signals>& signals,
                                         const std::vector<bool>& held_out, std::size_t most);

/// Simulates a joint again from what its log says of its motor. Not for a dynamometer (whose motion
/// is imposed) or an arm. Keeps references to its arguments.
class Replay {
 public:
  /// `offset_A` is subtracted from the logged current.
  Replay(const Bench& bench, const std::vector<Signals>& signals, double offset_A);

  static bool can_replay(const Bench& bench);

  /// (n x 1) Simulated less measured output positions, in rad (m on a linear axis), of each of the
  /// window's n = last - first + 1 samples; half a turn where the simulation diverged.
  Eigen::VectorXd errors(const actuator::Actuator& actuator, const ReplayWindow& window) const;

 private:
  const Bench& bench_;
  std::vector<std::unique_ptr<simulation::Plant>> plants_;  ///< Plants by stretch.
  const std::vector<Signals>& signals_;
  double offset_A_;
};

}  // namespace torquewright::identification
