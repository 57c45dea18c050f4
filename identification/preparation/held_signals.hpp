// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "identification/preparation/preparation.hpp"

namespace torquewright::identification {

/// The signals that stand for a log, stretch by stretch: all of one in memory, evenly spread runs
/// of a longer one; and the same once more with as much noise added as their channels have.
struct HeldSignals {
  std::vector<Signals> rows;
  std::vector<Signals> replica;
  /// Returns a run at the log's own rate, without a filter; what is usable, the direction and,
  /// beside a torque sensor, the acceleration are taken from the filtered signals. Nothing for a
  /// map without time.
  std::function<std::optional<Signals>(std::size_t run)> unfiltered;
};

/// Prepares the signals that stand for a log. Their `unfiltered` keeps a reference to the log, and
/// to what the bench points to.
HeldSignals held_signals(const Log& log, const Bench& bench, const NoiseLevels& levels,
                         std::uint64_t seed);

}  // namespace torquewright::identification
