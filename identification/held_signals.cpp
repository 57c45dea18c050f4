// SPDX-License-Identifier: Apache-2.0
#include "identification/held_signals.hpp"

#include <random>

#include "identification/log/spread_runs.hpp"

namespace torquewright::identification {

HeldSignals held_signals(const Log& log, const Bench& bench, const NoiseLevels& levels,
                         std::uint64_t seed) {
  PreparationOptions once_more;
  once_more.noise = &levels;
  once_more.seed = seed;
  std::mt19937_64 unused, random(seed);
  HeldSignals held;
  for (const std::size_t run : spread_runs(log.runs)) {
    auto signals = prepare_run(log, run, bench, levels, {}, unused);
    if (!signals) continue;
    held.rows.push_back(*std::move(signals));
    held.replica.push_back(*prepare_run(log, run, bench, levels, once_more, random));
  }
  return held;
}

}  // namespace torquewright::identification
