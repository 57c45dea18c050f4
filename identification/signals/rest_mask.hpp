// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "identification/signals/bench.hpp"
#include "identification/signals/channel_noise.hpp"

namespace torquewright::identification {

/// Standard deviations of a position's noise within which it may move at rest. A choice of ours.
constexpr double kPlayDeviations = 3.0;

/// How far the output's position may move by its noise alone, in rad (or m): kPlayDeviations of its
/// best channel.
double position_play(const Bench& bench, const NoiseLevels& levels);

/// Standard deviation of the noise on the velocity that tells the output's motion, in rad/s (or
/// m/s).
double speed_deviation(const Bench& bench, const NoiseLevels& levels);

/// Rests longer than this are masked (docs/derivations/identification.md section 3).
constexpr double kStandstill_s = 0.015;

/// Returns 1 for samples where the output rests for longer than kStandstill_s (friction is
/// undetermined there), around them as far as the filters carry, and at both ends, where the
/// filters have not settled. Requires step_s > 0.
std::vector<std::uint8_t> rest_mask(const std::vector<double>& velocity_rad_s, double play_rad,
                                    double step_s, double longer_than_s = kStandstill_s);

}  // namespace torquewright::identification
