// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/tree/refutation.hpp"

#include <algorithm>
#include <vector>

#include "gearbox/proof/gears/root_form.hpp"

namespace torquewright::gearbox::proof {
namespace {

Interval ratio_interval(const Alternative& alternative) {
  return Interval(alternative.least_ratio, alternative.greatest_ratio);
}

/// Teeth at the corner that satisfies the constraint if any point of the box does.
Teeth best_corner(const Constraint& constraint, const Box& box) {
  const bool is_second = constraint.place == 2;
  Point corner = box.upper;
  switch (constraint.family) {
    case ConstraintFamily::kRotorBore:
      corner = box.lower;
      break;
    case ConstraintFamily::kRingWall:
      corner = {box.lower[0], box.lower[1], box.upper[2]};
      break;
    case ConstraintFamily::kCarrierClearance:
    case ConstraintFamily::kNeighbourClearance:
      // (S + P1) sin(pi/n) - P1 + d - 2 falls with P1 in layer 2 as well.
      corner[1] = box.lower[1];
      break;
    case ConstraintFamily::kPositiveTeeth:
      corner[2] = box.lower[2];
      break;
    case ConstraintFamily::kMinTeeth:
    case ConstraintFamily::kUndercut:
    case ConstraintFamily::kRingTip:
    case ConstraintFamily::kShaperFeed:
      if (is_second) corner[2] = box.lower[2];
      break;
    case ConstraintFamily::kHobRootForm:
      if (is_second) corner[2] = box.lower[2];
      if (constraint.place == 0) corner = box.lower;
      break;
    default:
      break;
  }
  return teeth_at(corner);
}

/// The smallest planet and the largest ring do best, and need not belong to one corner.
bool fails_shaper_everywhere(const Constraint& constraint, const Alternative& alternative,
                             const Box& box) {
  const TeethRange range = teeth_in(box);
  if (alternative.train->is_stepped() && range.is_empty()) return true;  // holds no design
  return !has_root_form_of_shaper(*alternative.problem, planet(range.least, constraint.place),
                                  ring(range.most, constraint.place));
}

bool needs_ratio(Measure measure) {
  return measure == Measure::kForwardEfficiency || measure == Measure::kBackwardEfficiency ||
         measure == Measure::kReflectedInertia;
}

bool violates_ratio(const Claim& claim, const Alternative& alternative, const Box& box) {
  return claim.holds(ConstraintFamily::kRatio) &&
         (exceeds_everywhere(alternative.greatest_ratio, alternative, box) ||
          falls_short_everywhere(alternative.least_ratio, alternative, box));
}

/// |i/G - 1| exceeds the reference's where i lies outside the range which that sets.
bool has_greater_ratio_error(const Claim& claim, const Alternative& alternative, const Box& box) {
  const Rational& target = alternative.problem->target_ratio;
  const Rational reach = abs(target) * *claim.threshold->exact;
  return exceeds_everywhere(target + reach, alternative, box) ||
         falls_short_everywhere(target - reach, alternative, box);
}

/// Whether the quantity is worse than `reference` by more than `margin` at every design of the box,
/// in doubles. Empty: they are no help, or leave it open at a point or by so little that more bits
/// may tell.
std::optional<bool> falls_short_in_doubles(const Quantity& quantity, const Alternative& alternative,
                                           const Box& box, const RoughInterval& allowed,
                                           const RoughInterval& reference,
                                           const RoughInterval& margin) {
  const auto enclosure = rough_enclosure_on(quantity, alternative, box, allowed);
  if (!enclosure) return std::nullopt;
  const RoughInterval advantage =
      (quantity.greater_is_better() ? *enclosure - reference : reference - *enclosure) + margin;
  if (advantage.certainly_negative()) return true;
  if (box.is_point()) return std::nullopt;
  // Some hundred roundings of 2^-53 widen it by less than this.
  static const RoughInterval share(Rational(1, 1'000'000'000));
  const RoughInterval roughness = share * (abs(reference) + abs(*enclosure)).upper();
  if ((advantage - roughness).certainly_negative()) return std::nullopt;
  return false;
}

std::optional<bool> is_worse_in_doubles(const Claim& claim, const Alternative& alternative,
                                        const Box& box) {
  static const RoughInterval equal_share(Rational(1, 1'000'000'000'000));
  const RoughInterval threshold = claim.threshold->enclosure;
  return falls_short_in_doubles(*claim.quantity, alternative, box, ratio_interval(alternative),
                                threshold, abs(threshold) * equal_share);
}

bool is_worse_everywhere(const Claim& claim, const Alternative& alternative, const Box& box) {
  const Quantity& quantity = *claim.quantity;
  if (alternative.train->is_stepped() && teeth_in(box).is_empty()) return true;  // holds no design
  if (quantity.measure == Measure::kRatioError) {
    return has_greater_ratio_error(claim, alternative, box);
  }
  if (needs_ratio(quantity.measure) && violates_ratio(claim, alternative, box)) return true;
  if (const auto is_worse = is_worse_in_doubles(claim, alternative, box)) return *is_worse;
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

/// Whether no design of the box meets the floor. What the ratio tells of it counts where the claim
/// asks for the ratio.
bool misses_floor_everywhere(const Claim& claim, const Constraint& constraint,
                             const Alternative& alternative, const Box& box) {
  if (alternative.train->is_stepped() && teeth_in(box).is_empty()) return true;  // holds no design
  const FloorRecord& floor = kFloors[static_cast<std::size_t>(constraint.place)];
  const Quantity quantity = floor_quantity(floor.quantity);
  if (needs_ratio(quantity.measure) && violates_ratio(claim, alternative, box)) return true;
  if (box.is_point()) return !satisfies(constraint, alternative, teeth_at(box.lower));
  const Interval from(met_from(floor, *(alternative.problem->floors.*floor.limit)));
  static const Interval any_ratio(Rational(1), Rational(1'000'000'000'000));
  const Interval allowed =
      claim.holds(ConstraintFamily::kRatio) ? ratio_interval(alternative) : any_ratio;
  if (falls_short_in_doubles(quantity, alternative, box, allowed, from, 0) == true) return true;
  const Interval spare = enclosure_on(quantity, alternative, box, allowed) - from;
  return floor.is_ceiling ? spare.certainly_positive() : spare.certainly_negative();
}

bool fails_everywhere(const Claim& claim, const Alternative& alternative,
                      const Condition& condition, const Box& box) {
  switch (condition.kind) {
    case Condition::Kind::kQuantity:
      return is_worse_everywhere(claim, alternative, box);
    case Condition::Kind::kRatioMax:
      return exceeds_everywhere(alternative.greatest_ratio, alternative, box);
    case Condition::Kind::kRatioMin:
      return falls_short_everywhere(alternative.least_ratio, alternative, box);
    case Condition::Kind::kConstraint:
      if (condition.constraint->family == ConstraintFamily::kShaperRootForm) {
        return fails_shaper_everywhere(*condition.constraint, alternative, box);
      }
      if (condition.constraint->family == ConstraintFamily::kFloor) {
        return misses_floor_everywhere(claim, *condition.constraint, alternative, box);
      }
      return !satisfies(*condition.constraint, alternative,
                        best_corner(*condition.constraint, box));
  }
  return false;
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
  return std::any_of(claim.hypotheses.begin(), claim.hypotheses.end(), [&](const Constraint& each) {
    return !satisfies(each, alternative, teeth_at(point));
  });
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
  // Constraints and ratios are judged exactly on boxes; bisecting would find no more.
  const bool gains_by_bisection =
      condition.kind == Condition::Kind::kQuantity ||
      (condition.constraint && condition.constraint->family == ConstraintFamily::kFloor);
  const int most_pieces = gains_by_bisection ? kMostPieces : 1;
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
    const auto is_beyond = falls_short_in_doubles(
        quantity, alternative, piece, ratio_interval(alternative), Interval(bound), margin);
    if (is_beyond) return *is_beyond;
    const Interval excess =
        enclosure_on(quantity, alternative, piece, ratio_interval(alternative)) - Interval(bound);
    return quantity.greater_is_better() ? (excess - margin).certainly_negative()
                                        : (excess + margin).certainly_positive();
  });
}

bool allows(const Claim& claim, const Alternative& alternative, const Point& point) {
  // Quick, and most points of a leaf are worse: what holds no design, or has another ratio, may be
  // called worse as well, for it violates a hypothesis.
  const Box only{point, point};
  const bool is_design = !alternative.train->is_stepped() || !teeth_in(only).is_empty();
  if (claim.threshold && is_design && is_worse_in_doubles(claim, alternative, only) == true) {
    return true;
  }
  if (violates_a_hypothesis(claim, alternative, point)) return true;
  if (claim.threshold) {
    const int order =
        compare(*claim.quantity, value_at(*claim.quantity, alternative, point), *claim.threshold);
    if (order < 0) return true;
    if (order == 0 && claim.kind == ClaimKind::kLeastRelaxation) return true;
  }
  const Candidate candidate{point, alternative.planet_count, alternative.module_mm};
  return claim.listed.contains(candidate);
}

}  // namespace torquewright::gearbox::proof
