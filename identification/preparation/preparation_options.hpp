// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "identification/signals/channel_noise.hpp"

namespace torquewright::identification {

/// How raw channels become signals.
struct PreparationOptions {
  double cutoff_Hz = 25.0;
  double least_rate_Hz = 100.0;  ///< Signals are thinned to no less than this rate.
  /// Noise that is added to every raw channel first, from `seed`; null: none.
  const NoiseLevels* noise = nullptr;
  std::uint64_t seed = 0;
};

}  // namespace torquewright::identification
