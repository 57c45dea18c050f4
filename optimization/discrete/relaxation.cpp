// SPDX-License-Identifier: Apache-2.0
#include "optimization/discrete/relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::optimization {
namespace {

Interval over(const ConcaveForm& form, const Box& box) {
  Interval range = form.affine.over(box);
  for (const SquareTerm& term : form.squares) {
    const Interval u = term.u.over(box);
    range = range - term.weight * (term.v ? square_over(u, term.v->over(box)) : square(u));
  }
  return range;
}

bool is_constant(const ConcaveForm& form) {
  return form.squares.empty() &&
         std::all_of(
             form.affine.coefficients.begin(), form.affine.coefficients.end(),
             [](const Interval& slope) { return slope.lower == 0.0 && slope.upper == 0.0; });
}

// Where no shape is known of the cost, a constant is left of it, and its enclosure may be tighter.
ConcaveForm relaxed_gain(const Judge& judge, const Box& box) {
  const Goal& goal = judge.problem().goal;
  ConcaveForm form = concave_above(goal.maximise ? goal.value : -goal.value, box);
  const Interval greatest = -Interval(judge.cost_over(box).lower);
  if (is_constant(form) && !(form.affine.constant.upper < greatest.upper)) {
    form.affine.constant = greatest;
  }
  return form;
}

// The greatest value, over the box, of `form` linearised at `point`.
Interval linearised_maximum(const ValueAndSlope& at_point, const Box& box,
                            std::span<const double> point) {
  Interval total = at_point.value;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Interval to_lower = box[i].interval().lower - Interval(point[i]);
    const Interval to_upper = box[i].interval().upper - Interval(point[i]);
    total = total + max(at_point.slope[i] * to_lower, at_point.slope[i] * to_upper);
  }
  return total;
}

void add(ValueAndSlope& sum, const ValueAndSlope& part, double factor) {
  sum.value = sum.value + part.value * Interval(factor);
  for (std::size_t i = 0; i < sum.slope.size(); ++i) {
    sum.slope[i] = sum.slope[i] + part.slope[i] * Interval(factor);
  }
}

}  // namespace

bool has_shape(const Judge& judge) {
  return !is_constant(relaxed_gain(judge, judge.problem().domain));
}

Relaxation relax_box(const Judge& judge, const Box& box) {
  Relaxation result{box, {}, relaxed_gain(judge, box), 1.0, judge.condition_count()};
  for (std::size_t i = 0; i < judge.condition_count(); ++i) {
    if (!judge.on_boxes(i)) continue;
    ConcaveForm form = concave_above(judge.condition(i).body, box);
    if (is_constant(form)) continue;  // says no more than the interval that left the box open
    const Interval range = over(form, box);
    const double scale = std::max(std::abs(range.lower), std::abs(range.upper));
    if (std::isfinite(scale) && scale > 0.0) {
      result.conditions.push_back({i, std::move(form), scale});
    }
  }
  const Interval range = over(result.gain, box);
  const double width = range.upper - range.lower;
  if (std::isfinite(width) && width > 0.0) result.gain_scale = width;
  return result;
}

DualBound dual_bound(const Relaxation& relaxation, const DualPoint& dual) {
  std::vector<double> point = dual.point;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Interval range = relaxation.box[i].interval();
    point[i] = std::clamp(point[i], range.lower, range.upper);
  }
  ValueAndSlope sum{0.0, std::vector<Interval>(point.size(), Interval(0.0))};
  for (const RelaxedCondition& condition : relaxation.conditions) {
    const double multiplier = dual.multipliers[condition.condition];
    if (!std::isfinite(multiplier) || multiplier <= 0.0) continue;
    add(sum, evaluate(condition.form, point), multiplier);
  }
  const bool is_infeasible = linearised_maximum(sum, relaxation.box, point).upper < 0.0;
  add(sum, evaluate(relaxation.gain, point), 1.0);
  const double greatest = linearised_maximum(sum, relaxation.box, point).upper;
  return {std::isnan(greatest) ? -HUGE_VAL : -greatest, is_infeasible};
}

}  // namespace torquewright::optimization
