// SPDX-License-Identifier: Apache-2.0
#include "optimization/relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::optimization {
namespace {

Expression cost_expression(const Goal& goal) { return goal.maximise ? -goal.value : goal.value; }

double largest_size(const ConcaveForm& form, const Box& box) {
  Interval range = form.affine.over(box);
  for (const SquareTerm& term : form.squares) {
    const Interval u = term.u.over(box);
    range = range - term.weight * (term.v ? square_over(u, term.v->over(box)) : square(u));
  }
  return std::max(std::abs(range.lower), std::abs(range.upper));
}

// Where no shape is known of the cost, a constant is left of it, and its enclosure may be tighter.
ConcaveForm relaxed_cost(const Judge& judge, double ceiling, const Box& box) {
  const Goal& goal = judge.problem().goal;
  ConcaveForm form = concave_above(Expression(ceiling) - cost_expression(goal), box);
  const bool is_constant =
      form.squares.empty() &&
      std::all_of(form.affine.coefficients.begin(), form.affine.coefficients.end(),
                  [](const Interval& slope) { return slope.lower == 0.0 && slope.upper == 0.0; });
  const Interval bound = Interval(ceiling) - Interval(judge.cost_over(box).lower);
  if (is_constant && !(form.affine.constant.upper < bound.upper)) form.affine.constant = bound;
  return form;
}

}  // namespace

std::vector<RelaxedCondition> relax_conditions(const Judge& judge, double ceiling, const Box& box) {
  std::vector<RelaxedCondition> result;
  const auto add = [&](std::size_t condition, ConcaveForm form) {
    const double scale = largest_size(form, box);
    if (std::isfinite(scale) && scale > 0.0) result.push_back({condition, std::move(form), scale});
  };
  for (std::size_t i = 0; i < judge.condition_count(); ++i) {
    if (judge.on_boxes(i)) add(i, concave_above(judge.condition(i).body, box));
  }
  if (std::isfinite(ceiling)) add(kQuantity, relaxed_cost(judge, ceiling, box));
  return result;
}

double greatest_sum(const std::vector<RelaxedCondition>& conditions, const Box& box,
                    const Refutation& refutation) {
  Interval total = 0.0;
  std::vector<Interval> slope(box.size(), Interval(0.0));
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const double multiplier = refutation.multipliers[c];
    if (!std::isfinite(multiplier) || multiplier <= 0.0) continue;
    const ValueAndSlope part = evaluate(conditions[c].form, refutation.point);
    total = total + part.value * Interval(multiplier);
    for (std::size_t i = 0; i < box.size(); ++i) {
      slope[i] = slope[i] + part.slope[i] * Interval(multiplier);
    }
  }
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Interval to_lower = box[i].interval().lower - Interval(refutation.point[i]);
    const Interval to_upper = box[i].interval().upper - Interval(refutation.point[i]);
    total = total + max(slope[i] * to_lower, slope[i] * to_upper);
  }
  return std::isnan(total.upper) ? HUGE_VAL : total.upper;
}

}  // namespace torquewright::optimization
