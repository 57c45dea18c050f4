// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "identification/signals/bench.hpp"
#include "identification/signals/channel_noise.hpp"

namespace torquewright::identification {

constexpr double kPlayDeviations = 3.0;  ///< Of noise, in a position's play.

/// How far the output's position may move within its noise, in rad (or m): three deviations of its
/// best channel.
double position_play(const Bench& bench, const NoiseLevels& levels);

constexpr double kStandstill_s = 0.015;  ///< Longer rests are masked.

/// 1 where the output rests for longer than that (friction is undetermined there), and around it as
/// far as the filters carry what happens there; and at both ends, where the filters have not
/// settled. step_s > 0.
std::vector<std::uint8_t> rest_mask(const std::vector<double>& velocity_rad_s, double play_rad,
                                    double step_s, double longer_than_s = kStandstill_s);

}  // namespace torquewright::identification
