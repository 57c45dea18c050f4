// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/quantity.hpp"

#include <algorithm>

#include "gearbox/proof/bodies.hpp"
#include "gearbox/proof/contact_ratio.hpp"
#include "gearbox/proof/efficiency.hpp"

namespace torquewright::gearbox::proof {
namespace {

Interval number(std::int64_t value) { return Interval(static_cast<long>(value)); }

Rational whole(std::int64_t value) { return Rational(static_cast<long>(value)); }

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
  return alternative.module_mm * (whole(sun) - Rational(5, 2)) -
         2 * alternative.problem->hollow_shaft_wall_mm;
}

Rational ring_pitch_mm(const Alternative& alternative, const Point& point) {
  return alternative.module_mm * whole(ring(point, 1));
}

Rational ring_blank_mm(const Alternative& alternative, const Point& point) {
  return alternative.module_mm * (whole(ring(point, 1)) + Rational(5, 2)) +
         2 * alternative.ring_wall_mm;
}

std::optional<Rational> exact_value(const Quantity& quantity, const Alternative& alternative,
                                    const Point& point) {
  switch (quantity.measure) {
    case Measure::kPaperCost:
      return paper_cost<Rational>(whole(point[0]), whole(ring(point, 1)) - bore_teeth(alternative),
                                  whole(point[1]), whole(point[2]), whole(ring(point, 2)));
    case Measure::kHollowShaft:
      return hollow_shaft_mm(alternative, point[0]);
    case Measure::kTeeth:
      return whole(point[static_cast<std::size_t>(quantity.gear)]);
    case Measure::kRingPitchDiameter:
      return ring_pitch_mm(alternative, point);
    case Measure::kRatioError:
      return abs(Rational(ratio_of(alternative, point) / alternative.problem->target_ratio - 1));
    case Measure::kRingBlankDiameter:
      return ring_blank_mm(alternative, point);
    default:
      return std::nullopt;
  }
}

Interval paper_cost_on(const Alternative& alternative, const Box& box) {
  const auto range = [](std::int64_t least, std::int64_t most) {
    return Interval(whole(least), whole(most));
  };
  const Interval gap =
      range(ring(box.lower, 1), ring(box.upper, 1)) - Interval(bore_teeth(alternative));
  const Interval sun = range(box.lower[0], box.upper[0]);
  return Interval(1) / square(sun) + square(gap) + square(range(box.lower[1], box.upper[1])) +
         square(range(box.lower[2], box.upper[2])) +
         square(range(ring(box.lower, 2), ring(box.upper, 2)));
}

/// pi/n - asin(P1/(S + P1)): grows with S, falls with P1.
Interval carrier_clearance_on(const Alternative& alternative, const Box& box) {
  const auto share = [](std::int64_t sun, std::int64_t first) {
    return number(first) / number(sun + first);
  };
  return pi() / number(alternative.planet_count) -
         asin(hull(share(box.upper[0], box.lower[1]), share(box.lower[0], box.upper[1])));
}

Interval neighbour_clearance_on(const Alternative& alternative, const Box& box) {
  // Multiplied out so that each variable stands once: sin(pi/n) <= 1, so P1 pulls layer 1 down.
  const Interval sun = Interval(whole(box.lower[0]), whole(box.upper[0])) * alternative.sine;
  const Interval first(whole(box.lower[1]), whole(box.upper[1]));
  Interval least = sun - first * (1 - alternative.sine) - 2;
  if (!alternative.planetary) {
    const Interval second(whole(box.lower[2]), whole(box.upper[2]));
    least = min(least, sun + first * alternative.sine - second - 2);
  }
  return least * Interval(alternative.module_mm);
}

Interval contact_ratio_on(const Alternative& alternative, const Box& box) {
  Interval least = min(contact_ratio(box, 0), contact_ratio(box, 1));
  return alternative.planetary ? least : min(least, contact_ratio(box, 2));
}

/// i falls with S and grows with P2; the two factors of 2/(1 - P2/P1) (1 + (P1 + P2)/S) bound it.
Interval ratio_on(const Alternative& alternative, const Box& box) {
  if (alternative.planetary) {
    return hull(Interval(ratio_of(alternative, {box.upper[0], box.lower[1], 0})),
                Interval(ratio_of(alternative, {box.lower[0], box.upper[1], 0})));
  }
  const Interval second(whole(box.lower[2]), whole(box.upper[2]));
  const Interval first(whole(box.lower[1]), whole(box.upper[1]));
  const Interval sun(whole(box.lower[0]), whole(box.upper[0]));
  return 2 / (1 - second / first) * (1 + (first + second) / sun);
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

std::string_view objective_name(Objective objective) {
  switch (objective) {
    case Objective::kPaperCost:
      return "paper_cost";
    case Objective::kMass:
      return "mass";
    case Objective::kHollowShaft:
      return "hollow_shaft";
    case Objective::kForwardEfficiency:
      return "forward_efficiency";
    case Objective::kBackwardEfficiency:
      return "backward_efficiency";
    case Objective::kReflectedInertia:
      return "reflected_inertia";
  }
  return "";
}

Interval enclosure_on(const Quantity& quantity, const Alternative& alternative, const Box& box,
                      const Interval& allowed_ratio) {
  const bool turns_forward = box.lower[1] > box.upper[2];
  const Interval ratio =
      turns_forward ? intersection(allowed_ratio, ratio_on(alternative, box)) : allowed_ratio;
  switch (quantity.measure) {
    case Measure::kPaperCost:
      return paper_cost_on(alternative, box);
    case Measure::kMass:
      return total_mass_kg(alternative, box);
    case Measure::kForwardEfficiency:
      return forward_efficiency(alternative, box, ratio);
    case Measure::kBackwardEfficiency:
      return backward_efficiency(alternative, box, ratio);
    case Measure::kReflectedInertia:
      return reflected_inertia_kg_m2(alternative, box, ratio);
    case Measure::kCarrierClearance:
      return carrier_clearance_on(alternative, box);
    case Measure::kContactRatio:
      return contact_ratio_on(alternative, box);
    case Measure::kNeighbourClearance:
      return neighbour_clearance_on(alternative, box);
    case Measure::kRatioError:
      return abs(ratio_on(alternative, box) / Interval(alternative.problem->target_ratio) - 1);
    case Measure::kHollowShaft:
    case Measure::kTeeth:
    case Measure::kRingPitchDiameter:
    case Measure::kRingBlankDiameter:
      break;
  }
  // Grow with every variable they depend on.
  return Interval(*exact_value(quantity, alternative, box.lower),
                  *exact_value(quantity, alternative, box.upper));
}

Value value_at(const Quantity& quantity, const Alternative& alternative, const Point& point) {
  if (const auto exact = exact_value(quantity, alternative, point)) {
    return {Interval(*exact), *exact};
  }
  const bool has_ratio = alternative.planetary || point[1] != point[2];
  const Interval ratio = has_ratio ? Interval(ratio_of(alternative, point)) : Interval(0);
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
