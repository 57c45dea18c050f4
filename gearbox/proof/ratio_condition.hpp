// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/alternative.hpp"

namespace torquewright::gearbox::proof {

/// Ratios from `least` to `greatest`, both included.
struct RatioRange {
  Rational least, greatest;
};

/// i = 2 P1 O / (S (P1 - P2)), planetary 2 (S + P)/S. A design without a ratio (P1 = P2) has none
/// in any range.
bool has_ratio_in(const RatioRange& range, const Alternative& alternative, const Point& point);

/// Requires P1 != P2.
Rational ratio_of(const Alternative& alternative, const Point& point);

/// For h > 0: every whole point of the box has a ratio above h, or P1 <= P2. Exact.
bool exceeds_everywhere(const Rational& h, const Alternative& alternative, const Box& box);

/// For h > 0: every whole point has P1 > P2 and a ratio below h. Exact.
bool falls_short_everywhere(const Rational& h, const Alternative& alternative, const Box& box);

/// True: every whole point of the box has a ratio above the range, or none (P1 <= P2), for a range
/// of positive ratios; for one of negative ratios: a negative one above it. Exact for positive
/// ranges, sufficient for negative ones; never true for a range that holds zero.
bool all_above(const RatioRange& range, const Alternative& alternative, const Box& box);

/// True: every whole point has a positive ratio below the range; for a range of negative ratios:
/// one below it, or none, or a positive one.
bool all_below(const RatioRange& range, const Alternative& alternative, const Box& box);

}  // namespace torquewright::gearbox::proof
