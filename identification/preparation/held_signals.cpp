// SPDX-License-Identifier: Apache-2.0
#include "identification/preparation/held_signals.hpp"

#include <random>

#include "identification/log/spread_runs.hpp"

namespace torquewright::identification {
namespace {

constexpr double kEveryFrequency_Hz = 1e12;

std::optional<Signals> unfiltered_run(const Log& log, std::size_t run, const Bench& bench,
                                      const NoiseLevels& levels) {
  if (log.runs.head(run).is_map) return std::nullopt;
  PreparationOptions filtered, raw;
  filtered.least_rate_Hz = raw.least_rate_Hz = raw.cutoff_Hz = kEveryFrequency_Hz;
  std::mt19937_64 unused;
  const auto smooth = prepare_run(log, run, bench, levels, filtered, unused);
  auto signals = prepare_run(log, run, bench, levels, raw, unused);
  if (!smooth || !signals) return std::nullopt;
  signals->usable = smooth->usable;
  // A sensor has the torque itself; what the rotor takes of it by two derivatives of a position
  // would be noise. Without a sensor these derivatives are what the current is compared with.
  const bool is_sensor = bench.load_side == LoadSide::kSensor;
  if (is_sensor) signals->motor_acceleration_rad_s2 = smooth->motor_acceleration_rad_s2;
  for (std::size_t i = 0; i < signals->size(); ++i) {
    signals->at[i].direction = smooth->at[i].direction;
    signals->filtered_direction[i] = smooth->at[i].direction;
    if (is_sensor) signals->at[i].acceleration_rad_s2 = smooth->at[i].acceleration_rad_s2;
  }
  return signals;
}

}  // namespace

HeldSignals held_signals(const Log& log, const Bench& bench, const NoiseLevels& levels,
                         std::uint64_t seed) {
  PreparationOptions once_more;
  once_more.noise = &levels;
  once_more.seed = seed;
  std::mt19937_64 unused, random(seed);
  HeldSignals held;
  held.unfiltered = [&log, bench, levels](std::size_t run) {
    return unfiltered_run(log, run, bench, levels);
  };
  for (const std::size_t run : spread_runs(log.runs)) {
    auto signals = prepare_run(log, run, bench, levels, {}, unused);
    if (!signals) continue;
    held.rows.push_back(*std::move(signals));
    held.replica.push_back(*prepare_run(log, run, bench, levels, once_more, random));
  }
  return held;
}

}  // namespace torquewright::identification
