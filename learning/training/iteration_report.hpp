// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace torquewright::learning {

/// An episode that is over.
struct EpisodeReport {
  std::uint64_t episode = 0;  ///< The number that begin() was given.
  int copy = 0;               ///< Of which environment.
  int steps = 0;
  bool was_cut = false;         ///< Its time was up, rather than that it ended.
  std::vector<double> returns;  ///< Sum of rewards, not discounted, one per head.
};

/// What one iteration did.
struct IterationReport {
  std::int64_t iteration = 0;           ///< 1 for the first.
  std::int64_t steps = 0;               ///< Of all copies, since the beginning.
  std::vector<EpisodeReport> episodes;  ///< Over in this iteration: copy by copy, in order of time.

  double kl = 0.0;             ///< Mean divergence of the new policy from the old, in nat.
  double learning_rate = 0.0;  ///< At the end of the iteration.
  double deviation = 0.0;      ///< Mean over actions.
  double entropy = 0.0;        ///< Of the action's distribution, in nat.
  double surrogate = 0.0;      ///< Mean of the clipped surrogate in the last epoch.
  double clipped_share = 0.0;  ///< Of samples whose ratio left the clip, in the last epoch.
  double value_loss = 0.0;     ///< Mean square of the critics' error in the last epoch, in units of
                               ///< the returns' deviation.
  double estimator_loss = 0.0;  ///< The same of the estimator's guess. 0: none.
  double symmetry_loss = 0.0;   ///< Mean square of what the mirror shows. 0: none.

  double acting_s = 0.0;    ///< Wall time in environments and for their actions,
  double learning_s = 0.0;  ///< and for gradients. Neither is part of what is saved.
};

}  // namespace torquewright::learning
