// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/alternative.hpp"

namespace torquewright::gearbox::proof {

/// Ratios from `least` to `greatest`, both included.
struct RatioRange {
  Rational least, greatest;
};

/// i = 2 P1 O / (S (P1 - P2)), planetary 2 (S + P)/S. Requires P1 > P2.
Rational ratio_of(const Alternative& alternative, const Teeth& teeth);
bool has_ratio_in(const RatioRange& range, const Alternative& alternative, const Teeth& teeth);

/// Whether every whole point of the box has a ratio above (below) `limit`, judged in the form
/// without a pole: d - phi < 0 (> 0) at the one corner that comes nearest. Exact over the real box.
bool exceeds_everywhere(const Rational& limit, const Alternative& alternative, const Box& box);
bool falls_short_everywhere(const Rational& limit, const Alternative& alternative, const Box& box);

}  // namespace torquewright::gearbox::proof
