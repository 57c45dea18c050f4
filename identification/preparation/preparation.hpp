// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "identification/preparation/preparation_options.hpp"
#include "identification/signals/bench.hpp"
#include "identification/signals/channel_noise.hpp"

namespace torquewright::identification {

/// Prepares the signals of every stretch of the log that is long enough (at least 0.5 s and 16
/// samples). In a map without time the samples are taken as they are. `levels` are the noise levels
/// of the same joint.
std::vector<Signals> prepare(const Log& log, const Bench& bench, const NoiseLevels& levels,
                             const PreparationOptions& options);

/// Prepares one run, if it is long enough; noise is drawn from `random`. A piece of a stretch is
/// prepared with a second of its neighbours on either side.
std::optional<Signals> prepare_run(const Log& log, std::size_t run, const Bench& bench,
                                   const NoiseLevels& levels, const PreparationOptions& options,
                                   std::mt19937_64& random);

}  // namespace torquewright::identification
