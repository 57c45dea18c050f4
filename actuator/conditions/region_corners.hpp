// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "actuator/mor/mor_table.hpp"

namespace torquewright::actuator {

/// What stays the same from one corner to the next.
struct LimiterStretch {
  Limiter limiter;
  int sign;
  friend bool operator==(const LimiterStretch&, const LimiterStretch&) = default;
};

struct Corners {
  std::vector<double> speeds_rad_s;
  std::vector<LimiterStretch> stretches;  ///< One less: from each corner to the next.
  std::size_t rest = 0;  ///< The corner at rest from below; the next is from above.
};

/// From rest to rest: the jump between the two directions.
inline constexpr LimiterStretch kAtRest{Limiter::kCurrent, 2};
/// From the last row on one side of a jump to the first on the other, which are as close as
/// rounding allows.
inline constexpr LimiterStretch kJump{Limiter::kCurrent, 3};

using LimiterStretches = std::span<const LimiterStretch>;

const JointBound& bound_of(const JointRange& range, bool is_greatest);

/// The corners of one bound under one condition; nothing if the region has a gap.
std::optional<Corners> corners_of(const MorTable& table, bool is_greatest);

/// Whether one's stretches are those of the other, or some of them.
bool is_part_of(LimiterStretches one, LimiterStretches other);

/// The shortest sequence that both are part of. Both hold rest, once.
std::vector<LimiterStretch> merged_about_rest(const std::vector<LimiterStretch>& one,
                                              const std::vector<LimiterStretch>& other);

/// Where the stretches lie under another condition.
struct CornersExample {
  double voltage_V = 0.0;
  double temperature_K = 0.0;
  std::vector<double> corners_rad_s;
};

/// The share of the way through the stretches first to last at which those between would open: in
/// the middle of where they lie in the example. Nothing where they have no width there either.
std::optional<double> opening(const CornersExample& example, std::size_t first, std::size_t last);

/// The same corners with every stretch of the reference: one that is not there has no width. Where
/// it would part another in two it lies at the share that `opening_of(first, last)` tells, else at
/// the end. Nothing where the reference lacks a stretch that is there.
std::optional<Corners> stretched(
    const Corners& found, const std::vector<LimiterStretch>& reference,
    const std::function<std::optional<double>(std::size_t, std::size_t)>& opening_of =
        [](std::size_t, std::size_t) { return std::optional<double>(); });

}  // namespace torquewright::actuator
