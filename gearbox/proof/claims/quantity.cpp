// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/claims/quantity.hpp"

#include <algorithm>

#include "gearbox/proof/gears/bodies.hpp"
#include "gearbox/proof/gears/contact_ratio.hpp"
#include "gearbox/proof/gears/efficiency.hpp"
#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// Equation (1) with Z_P3 read as Z_P2; `Number` is Rational at points and Interval on boxes.
template <typename Number>
Number paper_cost(const Number& sun, const Number& fixed_ring_gap, const Number& first,
                  const Number& second, const Number& output_ring) {
  return Number(1) / (sun * sun) + fixed_ring_gap * fixed_ring_gap + first * first +
         second * second + output_ring * output_ring;
}

Rational bore_teeth(const Alternative& alternative) {
  return alternative.problem->rotor_inner_diameter_mm / alternative.module_mm;
}

Rational hollow_shaft_mm(const Alternative& alternative, std::int64_t sun) {
  return alternative.module_mm * (whole(sun) - 2 * alternative.problem->cutters.hob_depth()) -
         2 * alternative.hollow_shaft_wall_mm;
}

Rational ring_pitch_mm(const Alternative& alternative, const Teeth& teeth) {
  return alternative.module_mm * whole(ring(teeth, 1));
}

Rational ring_blank_mm(const Alternative& alternative, const Teeth& teeth) {
  return alternative.module_mm *
             (whole(ring(teeth, 1)) + 2 * alternative.problem->cutters.shaper_depth()) +
         2 * alternative.ring_wall_mm;
}

Rational axial_length_mm(const Problem& problem) {
  Rational sum_mm = 0;
  for (const auto& [layer, width_mm] : problem.face_width_mm) sum_mm += width_mm;
  return sum_mm;
}

std::int64_t teeth_of(const Quantity& quantity, const Teeth& teeth) {
  return quantity.gear == 0 ? teeth.sun : planet(teeth, quantity.gear);
}

std::optional<Rational> exact_value(const Quantity& quantity, const Alternative& alternative,
                                    const Teeth& teeth) {
  switch (quantity.measure) {
    case Measure::kPaperCost:
      return paper_cost<Rational>(whole(teeth.sun), whole(ring(teeth, 1)) - bore_teeth(alternative),
                                  whole(teeth.planet_1), whole(teeth.planet_2),
                                  whole(ring(teeth, 2)));
    case Measure::kHollowShaft:
      return hollow_shaft_mm(alternative, teeth.sun);
    case Measure::kTeeth:
      return whole(teeth_of(quantity, teeth));
    case Measure::kRingPitchDiameter:
      return ring_pitch_mm(alternative, teeth);
    case Measure::kRatioError:
      return abs(Rational(ratio_of(alternative, teeth) / alternative.problem->target_ratio - 1));
    case Measure::kRingBlankDiameter:
      return ring_blank_mm(alternative, teeth);
    case Measure::kAxialLength:
      return axial_length_mm(*alternative.problem);
    default:
      return std::nullopt;
  }
}

template <typename Number = Interval>
Number span(std::int64_t least, std::int64_t most) {
  return hull(number<Number>(least), number<Number>(most));
}

template <typename Number>
Number paper_cost_on(const Alternative& alternative, const TeethRange& range) {
  const auto& [least, most] = range;
  const auto span = [](std::int64_t low, std::int64_t high) {
    return proof::span<Number>(low, high);
  };
  const Number gap = span(ring(least, 1), ring(most, 1)) - Number(bore_teeth(alternative));
  return 1 / square(span(least.sun, most.sun)) + square(gap) +
         square(span(least.planet_1, most.planet_1)) + square(span(least.planet_2, most.planet_2)) +
         square(span(ring(least, 2), ring(most, 2)));
}

/// pi/n - asin(P1/(S + P1)): grows with S, falls with P1.
Interval carrier_clearance_on(const Alternative& alternative, const TeethRange& range) {
  const auto share = [](std::int64_t sun, std::int64_t first) {
    return number(first) / number(sun + first);
  };
  const auto& [least, most] = range;
  return pi() / number(alternative.planet_count) -
         asin(hull(share(most.sun, least.planet_1), share(least.sun, most.planet_1)));
}

Interval neighbour_clearance_on(const Alternative& alternative, const Box& box) {
  // Multiplied out so that each variable stands once: sin(pi/n) <= 1, so P1 pulls both layers down.
  const Interval common = span(box.lower[0], box.upper[0]) * alternative.sine -
                          span(box.lower[1], box.upper[1]) * (1 - alternative.sine) - 2;
  const Interval least = alternative.train->is_stepped()
                             ? min(common, common + span(box.lower[2], box.upper[2]))
                             : common;
  return least * Interval(alternative.module_mm);
}

Interval contact_ratio_on(const Alternative& alternative, const TeethRange& range) {
  Interval least = contact_ratio(range, 0);
  for (int mesh = 1; mesh <= alternative.train->layers(); ++mesh) {
    least = min(least, contact_ratio(range, mesh));
  }
  return least;
}

/// Without profile shift 2/r_b of the output ring, or 4/(r_bS + r_bR) of a train of one layer.
Interval backlash_on(const Alternative& alternative, const TeethRange& range) {
  const auto teeth = [&](const Teeth& z) {
    return alternative.train->is_stepped() ? ring(z, 2) : z.sun + ring(z, 1);
  };
  return 4 / (Interval(alternative.module_mm) * cos(pressure_angle()) *
              span(teeth(range.least), teeth(range.most)));
}

/// i = 2 (P1/d) (1 + (P1 + P2)/S): both factors fall with S and d and grow with P1; P1 > d.
template <typename Number>
Number ratio_on(const Alternative& alternative, const Box& box) {
  const TeethRange range = teeth_in(box);
  const auto& [least, most] = range;
  const auto of = [](std::int64_t value) { return number<Number>(value); };
  if (!alternative.train->is_stepped()) {
    return 2 * (1 + hull(of(least.planet_1) / of(most.sun), of(most.planet_1) / of(least.sun)));
  }
  const Number low = max(of(least.planet_1) / of(box.upper[2]), 1) *
                     (1 + of(least.planet_1 + least.planet_2) / of(most.sun));
  const Number high = of(most.planet_1) / of(box.lower[2]) *
                      (1 + of(most.planet_1 + most.planet_2) / of(least.sun));
  return 2 * hull(low, high);
}

/// Quantities that need neither angles nor fractions, in either arithmetic; empty for others.
template <typename Number>
std::optional<Number> smooth_enclosure_on(const Quantity& quantity, const Alternative& alternative,
                                          const Box& box, const Number& allowed_ratio) {
  const auto ratio = [&] {
    return intersection(allowed_ratio, ratio_on<Number>(alternative, box));
  };
  switch (quantity.measure) {
    case Measure::kPaperCost:
      return paper_cost_on<Number>(alternative, teeth_in(box));
    case Measure::kMass:
      return total_mass_kg<Number>(alternative, teeth_in(box));
    case Measure::kForwardEfficiency:
      return forward_efficiency<Number>(alternative, box, ratio());
    case Measure::kBackwardEfficiency:
      return backward_efficiency<Number>(alternative, box, ratio());
    case Measure::kReflectedInertia:
      return reflected_inertia_kg_m2<Number>(alternative, teeth_in(box), ratio());
    default:
      return std::nullopt;
  }
}

}  // namespace

bool Quantity::greater_is_better() const {
  switch (measure) {
    case Measure::kHollowShaft:
    case Measure::kForwardEfficiency:
    case Measure::kBackwardEfficiency:
    case Measure::kTeeth:
    case Measure::kCarrierClearance:
    case Measure::kContactRatio:
    case Measure::kNeighbourClearance:
      return true;
    default:
      return false;
  }
}

Quantity objective_quantity(Objective objective) {
  switch (objective) {
    case Objective::kPaperCost:
      return {Measure::kPaperCost};
    case Objective::kMass:
      return {Measure::kMass};
    case Objective::kHollowShaft:
      return {Measure::kHollowShaft};
    case Objective::kForwardEfficiency:
      return {Measure::kForwardEfficiency};
    case Objective::kBackwardEfficiency:
      return {Measure::kBackwardEfficiency};
    case Objective::kReflectedInertia:
      return {Measure::kReflectedInertia};
  }
  return {Measure::kPaperCost};
}

Quantity floor_quantity(FloorQuantity floor) {
  switch (floor) {
    case FloorQuantity::kForwardEfficiency:
      return {Measure::kForwardEfficiency};
    case FloorQuantity::kBackwardEfficiency:
      return {Measure::kBackwardEfficiency};
    case FloorQuantity::kHollowShaft:
      return {Measure::kHollowShaft};
    case FloorQuantity::kMass:
      return {Measure::kMass};
    case FloorQuantity::kReflectedInertia:
      return {Measure::kReflectedInertia};
    case FloorQuantity::kBacklash:
      return {Measure::kBacklash};
    case FloorQuantity::kAxialLength:
      break;
  }
  return {Measure::kAxialLength};
}

Interval enclosure_on(const Quantity& quantity, const Alternative& alternative, const Box& box,
                      const Interval& allowed_ratio) {
  if (const auto found = smooth_enclosure_on(quantity, alternative, box, allowed_ratio)) {
    return *found;
  }
  const TeethRange range = teeth_in(box);
  switch (quantity.measure) {
    case Measure::kCarrierClearance:
      return carrier_clearance_on(alternative, range);
    case Measure::kContactRatio:
      return contact_ratio_on(alternative, range);
    case Measure::kNeighbourClearance:
      return neighbour_clearance_on(alternative, box);
    case Measure::kBacklash:
      return backlash_on(alternative, range);
    case Measure::kRatioError:
      return abs(
          ratio_on<Interval>(alternative, box) / Interval(alternative.problem->target_ratio) - 1);
    default:
      break;
  }
  // Grow with every gear they depend on.
  return Interval(*exact_value(quantity, alternative, range.least),
                  *exact_value(quantity, alternative, range.most));
}

std::optional<RoughInterval> rough_enclosure_on(const Quantity& quantity,
                                                const Alternative& alternative, const Box& box,
                                                const RoughInterval& allowed_ratio) {
  return smooth_enclosure_on(quantity, alternative, box, allowed_ratio);
}

Value value_at(const Quantity& quantity, const Alternative& alternative, const Point& point) {
  if (const auto exact = exact_value(quantity, alternative, teeth_at(point))) {
    return {Interval(*exact), *exact};
  }
  const Interval ratio(ratio_of(alternative, teeth_at(point)));
  return {enclosure_on(quantity, alternative, Box{point, point}, ratio), std::nullopt};
}

Interval equality_margin(const Value& value) {
  if (value.exact) return 0;
  return abs(value.enclosure) * Interval(Rational(1, 1'000'000'000'000));
}

int compare(const Quantity& quantity, const Value& value, const Value& reference) {
  int order = 0;
  if (value.exact && reference.exact) {
    order = cmp(*value.exact, *reference.exact);
  } else {
    const Interval difference = value.enclosure - reference.enclosure;
    const Interval margin = equality_margin(reference);
    order = sign(difference - margin) > 0 ? 1 : sign(difference + margin) < 0 ? -1 : 0;
  }
  order = order > 0 ? 1 : order < 0 ? -1 : 0;
  return quantity.greater_is_better() ? order : -order;
}

}  // namespace torquewright::gearbox::proof
