// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/relaxation/relaxation.hpp"

#include "gearbox/proof/relaxation/concave_forms.hpp"

namespace torquewright::gearbox::proof {
namespace {

Linearization hollow_shaft_form(const Alternative& alternative, const Interval& least_mm,
                                const RealPoint& point) {
  const Interval module(alternative.module_mm);
  return affine(point,
                -least_mm -
                    module * Interval(Rational(2 * alternative.problem->cutters.hob_depth())) -
                    2 * Interval(alternative.hollow_shaft_wall_mm),
                {module, 0, 0});
}

/// Of the floors that are linear or concave; the search knows no form of the others.
std::optional<Linearization> linearize_floor(const FloorRecord& floor,
                                             const Alternative& alternative, const Box& box,
                                             const RealPoint& point) {
  const Interval from(met_from(floor, *(alternative.problem->floors.*floor.limit)));
  switch (floor.quantity) {
    case FloorQuantity::kHollowShaft:
      return hollow_shaft_form(alternative, from, point);
    case FloorQuantity::kMass:
      return mass_form(alternative, from, box, point);
    default:
      return std::nullopt;
  }
}

std::optional<Linearization> linearize_constraint(const Constraint& constraint,
                                                  const Alternative& alternative, const Box& box,
                                                  const RealPoint& point) {
  switch (constraint.family) {
    case ConstraintFamily::kRotorBore:
      return affine(point, alternative.largest_ring, {-1, -2, 0});
    case ConstraintFamily::kToothDifference:
      return affine(point, -Interval(static_cast<long>(alternative.planet_count)), {0, 0, 1});
    case ConstraintFamily::kPositiveTeeth:
      return teeth_form(1, -1, 2, point);
    case ConstraintFamily::kMinTeeth:
      return min_teeth_form(alternative, constraint.place, point);
    case ConstraintFamily::kCarrierClearance:
      return carrier_clearance_form(alternative, point);
    case ConstraintFamily::kNeighbourClearance:
      return neighbour_clearance_form(alternative, constraint.place, point);
    case ConstraintFamily::kUndercut:
      return undercut_form(*alternative.problem, constraint.place, point);
    case ConstraintFamily::kSunUnderLayer2:
      return sun_under_layer_2_form(alternative, point);
    case ConstraintFamily::kRingWall:
      return ring_wall_form(alternative, constraint.place, point);
    case ConstraintFamily::kRingTip:
      return ring_tip_form(alternative, constraint.place, point);
    case ConstraintFamily::kShaperFeed:
      return shaper_feed_form(alternative, constraint.place, point);
    case ConstraintFamily::kFloor:
      return linearize_floor(kFloors[static_cast<std::size_t>(constraint.place)], alternative, box,
                             point);
    default:
      return std::nullopt;
  }
}

std::optional<Linearization> linearize_quantity(const Claim& claim, const Alternative& alternative,
                                                const Box& box, const RealPoint& point) {
  const Value& threshold = *claim.threshold;
  const Interval& value = threshold.enclosure;
  const Interval module(alternative.module_mm);
  switch (claim.quantity->measure) {
    case Measure::kPaperCost:
      return paper_cost_form(alternative, value, box, point);
    case Measure::kHollowShaft:
      return hollow_shaft_form(alternative, value, point);
    case Measure::kTeeth:
      return teeth_form(1, -value, claim.quantity->gear, point);
    case Measure::kRingPitchDiameter:
      return affine(point, value, {-module, -2 * module, 0});
    case Measure::kMass:
      return mass_form(alternative, value + equality_margin(threshold), box, point);
    default:
      break;
  }
  const Interval ratio(alternative.least_ratio, alternative.greatest_ratio);
  const Interval advantage =
      enclosure_on(*claim.quantity, alternative, box, ratio) - threshold.enclosure;
  const Interval signed_advantage = claim.quantity->greater_is_better() ? advantage : -advantage;
  return affine(point, signed_advantage.upper() + equality_margin(threshold), {0, 0, 0});
}

}  // namespace

std::optional<Linearization> linearize(const Claim& claim, const Alternative& alternative,
                                       const Condition& condition, const Box& box,
                                       const RealPoint& point) {
  switch (condition.kind) {
    case Condition::Kind::kRatioMax:
      return ratio_max_form(alternative, point);
    case Condition::Kind::kRatioMin:
      return ratio_min_form(alternative, box, point);
    case Condition::Kind::kConstraint:
      return linearize_constraint(*condition.constraint, alternative, box, point);
    case Condition::Kind::kQuantity:
      return linearize_quantity(claim, alternative, box, point);
  }
  return std::nullopt;
}

}  // namespace torquewright::gearbox::proof
