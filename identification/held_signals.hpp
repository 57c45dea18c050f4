// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "identification/preparation.hpp"

namespace torquewright::identification {

/// The signals that stand for a log, stretch by stretch: all of one in memory, evenly spread runs
/// of a longer one; and the same once more with as much noise added as their channels have.
struct HeldSignals {
  std::vector<Signals> rows;
  std::vector<Signals> replica;
};
HeldSignals held_signals(const Log& log, const Bench& bench, const NoiseLevels& levels,
                         std::uint64_t seed);

}  // namespace torquewright::identification
