// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/refutation.hpp"

#include <algorithm>
#include <vector>

namespace torquewright::gearbox::proof {
namespace {

Interval ratio_interval(const Alternative& alternative) {
  return Interval(alternative.least_ratio, alternative.greatest_ratio);
}

RatioRange allowed_ratios(const Alternative& alternative) {
  return {alternative.least_ratio, alternative.greatest_ratio};
}

/// The corner that satisfies the constraint if any point of the box does.
Point best_corner(const Constraint& constraint, const Box& box) {
  const auto& [least_sun, least_first, least_second] = box.lower;
  const auto& [most_sun, most_first, most_second] = box.upper;
  switch (constraint.family) {
    case Family::kRotorBore:
    case Family::kRingWall:
      return box.lower;
    case Family::kCarrierClearance:
      return {most_sun, least_first, least_second};
    case Family::kNeighbourClearance:
      if (constraint.place == 1) return {most_sun, least_first, least_second};
      return {most_sun, most_first, least_second};
    case Family::kToothDifference:
    case Family::kSunUnderLayer2:
      return {most_sun, most_first, least_second};
    default:
      return box.upper;
  }
}

bool needs_ratio(Measure measure) {
  return measure == Measure::kForwardEfficiency || measure == Measure::kBackwardEfficiency ||
         measure == Measure::kReflectedInertia;
}

bool violates_ratio(const Claim& claim, const Alternative& alternative, const Box& box) {
  if (!claim.holds(Family::kRatio)) return false;
  const RatioRange range = allowed_ratios(alternative);
  if (box.is_point()) return !has_ratio_in(range, alternative, box.lower);
  return all_above(range, alternative, box) || all_below(range, alternative, box);
}

/// |i/G - 1| exceeds the reference's where i lies outside the range which that sets. Exact; designs
/// with P1 <= P2 are none, because tooth_difference is a hypothesis.
bool has_greater_ratio_error(const Claim& claim, const Alternative& alternative, const Box& box) {
  if (!alternative.planetary && !claim.holds(Family::kToothDifference)) return false;
  const Rational& target = alternative.problem->target_ratio;
  const Rational reach = abs(target) * *claim.threshold->exact;
  const Rational least = target - reach;
  const Rational greatest = target + reach;
  if (greatest > 0 && exceeds_everywhere(greatest, alternative, box)) return true;
  return least > 0 && falls_short_everywhere(least, alternative, box);
}

bool is_worse_everywhere(const Claim& claim, const Alternative& alternative, const Box& box) {
  const Quantity& quantity = *claim.quantity;
  if (quantity.measure == Measure::kRatioError) {
    return has_greater_ratio_error(claim, alternative, box);
  }
  if (needs_ratio(quantity.measure) && violates_ratio(claim, alternative, box)) return true;
  if (box.is_point()) {
    return compare(quantity, value_at(quantity, alternative, box.lower), *claim.threshold) < 0;
  }
  const Interval difference =
      enclosure_on(quantity, alternative, box, ratio_interval(alternative)) -
      claim.threshold->enclosure;
  const Interval margin = equality_margin(*claim.threshold);
  return quantity.greater_is_better() ? (difference + margin).certainly_negative()
                                      : (difference - margin).certainly_positive();
}

bool fails_everywhere(const Claim& claim, const Alternative& alternative,
                      const Condition& condition, const Box& box) {
  switch (condition.kind) {
    case Condition::Kind::kQuantity:
      return is_worse_everywhere(claim, alternative, box);
    case Condition::Kind::kRatioMax:
      return all_above(allowed_ratios(alternative), alternative, box);
    case Condition::Kind::kRatioMin:
      return all_below(allowed_ratios(alternative), alternative, box);
    case Condition::Kind::kConstraint:
      return !satisfies(*condition.constraint, alternative,
                        best_corner(*condition.constraint, box));
  }
  return false;
}

/// Everything but enclosures is exact on boxes; bisecting would find no more.
bool gains_by_bisection(const Condition& condition, const Alternative& alternative) {
  if (condition.kind == Condition::Kind::kQuantity) return true;
  return condition.kind != Condition::Kind::kConstraint && alternative.least_ratio <= 0;
}

/// An enclosure of an efficiency costs as much as this many points.
constexpr std::int64_t kPieceCost = 16;

/// Whether `settled(piece)` holds for pieces that make up the box.
template <typename Settled>
bool settled_in_pieces(const Box& box, int most_pieces, Budget& budget, Settled settled) {
  std::vector<Box> pending{box};
  for (int pieces = 0; !pending.empty(); ++pieces) {
    if (pieces == most_pieces || !budget.spend(kPieceCost)) return false;
    const Box piece = pending.back();
    pending.pop_back();
    if (settled(piece)) continue;
    if (piece.is_point()) return false;
    for (const Box& half : halves(piece)) pending.push_back(half);
  }
  return true;
}

bool violates_a_hypothesis(const Claim& claim, const Alternative& alternative, const Point& point) {
  return std::any_of(claim.hypotheses.begin(), claim.hypotheses.end(),
                     [&](const Constraint& each) { return !satisfies(each, alternative, point); });
}

bool is_refuted_by_a_hypothesis(const Claim& claim, const Alternative& alternative,
                                const Box& box) {
  if (box.is_point()) return violates_a_hypothesis(claim, alternative, box.lower);
  return violates_ratio(claim, alternative, box) ||
         std::any_of(claim.hypotheses.begin(), claim.hypotheses.end(), [&](const Constraint& each) {
           const auto condition = find_condition(claim, each.name);
           return condition && fails_everywhere(claim, alternative, *condition, box);
         });
}

}  // namespace

bool refutes(const Claim& claim, const Alternative& alternative, const Condition& condition,
             const Box& box, Budget& budget) {
  const int most_pieces = gains_by_bisection(condition, alternative) ? kMostPieces : 1;
  return settled_in_pieces(box, most_pieces, budget, [&](const Box& piece) {
    return fails_everywhere(claim, alternative, condition, piece);
  });
}

bool respects_bound(const Claim& claim, const Alternative& alternative, const Rational& bound,
                    const Box& box, Budget& budget) {
  const Quantity& quantity = *claim.quantity;
  const Interval margin = Interval(abs(bound)) * Interval(Rational(1, 1'000'000'000'000));
  return settled_in_pieces(box, 4 * kMostPieces, budget, [&](const Box& piece) {
    if (is_refuted_by_a_hypothesis(claim, alternative, piece)) return true;
    const Interval excess =
        enclosure_on(quantity, alternative, piece, ratio_interval(alternative)) - Interval(bound);
    return quantity.greater_is_better() ? (excess - margin).certainly_negative()
                                        : (excess + margin).certainly_positive();
  });
}

bool allows(const Claim& claim, const Alternative& alternative, const Point& point) {
  if (violates_a_hypothesis(claim, alternative, point)) return true;
  if (claim.threshold) {
    const int order =
        compare(*claim.quantity, value_at(*claim.quantity, alternative, point), *claim.threshold);
    if (order < 0) return true;
    if (order == 0 && claim.kind == ClaimKind::kLeastRelaxation) return true;
  }
  const Candidate candidate{point, alternative.planet_count, alternative.module_mm};
  return std::find(claim.listed.begin(), claim.listed.end(), candidate) != claim.listed.end();
}

}  // namespace torquewright::gearbox::proof
