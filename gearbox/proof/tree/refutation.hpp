// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/claims/claim.hpp"

namespace torquewright::gearbox::proof {

/// Steps of work left. A file of unknown origin must not keep the checker busy for ever.
struct Budget {
  std::int64_t steps = std::int64_t{1} << 25;
  bool spend(std::int64_t cost = 1) { return (steps -= cost) >= 0; }
  bool is_exhausted() const { return steps < 0; }
};

/// Boxes that one refutation may be cut into.
inline constexpr int kMostPieces = 4096;

/// Whether the condition fails at every whole point of the box, which is not empty. Where one look
/// at the whole box does not settle it, the box is bisected. False: not shown.
bool refutes(const Claim& claim, const Alternative& alternative, const Condition& condition,
             const Box& box, Budget& budget);

/// Whether no point of the box satisfies all hypotheses and is better than `bound`, up to a
/// millionth of a millionth of the bound. Bisects as well.
bool respects_bound(const Claim& claim, const Alternative& alternative, const Rational& bound,
                    const Box& box, Budget& budget);

/// Whether the claim lets the point be: it violates a hypothesis, or does worse than the reference,
/// or is listed, or, for a least relaxation, is as good.
bool allows(const Claim& claim, const Alternative& alternative, const Point& point);

}  // namespace torquewright::gearbox::proof
