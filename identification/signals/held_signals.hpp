// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "identification/signals/preparation.hpp"

namespace torquewright::identification {

/// The signals that stand for a log, stretch by stretch: all of one in memory, evenly spread runs
/// of a longer one; and the same once more with as much noise added as their channels have.
struct HeldSignals {
  std::vector<Signals> rows;
  std::vector<Signals> replica;
  /// One of the runs at the log's own rate, through no filter; what is usable, the direction and,
  /// beside a torque sensor, the acceleration are the filtered signals'. Nothing of a map without
  /// time.
  std::function<std::optional<Signals>(std::size_t run)> unfiltered;
};

/// Its `unfiltered` keeps a reference to the log, and what the bench points to.
HeldSignals held_signals(const Log& log, const Bench& bench, const NoiseLevels& levels,
                         std::uint64_t seed);

}  // namespace torquewright::identification
