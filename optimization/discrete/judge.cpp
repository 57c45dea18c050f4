// SPDX-License-Identifier: Apache-2.0
#include "optimization/discrete/judge.hpp"

#include <cmath>
#include <stdexcept>

namespace torquewright::optimization {
namespace {

std::vector<Direction> directions_of(const Condition& condition,
                                     const std::optional<Affine>& affine, std::size_t count) {
  std::vector<Direction> directions = condition.directions;
  directions.resize(count, Direction::kUnknown);
  if (!affine) return directions;
  for (std::size_t i = 0; i < count; ++i) {
    const Interval slope = affine->coefficients[i];
    if (slope.lower >= 0.0) directions[i] = Direction::kGrows;
    if (slope.upper <= 0.0) directions[i] = Direction::kFalls;
  }
  return directions;
}

Interval signed_cost(Interval value, bool maximise) { return maximise ? -value : value; }

}  // namespace

Judge::Judge(const Problem& problem) : problem_(problem), value_(problem.goal.value) {
  const std::size_t count = problem.variables.size();
  if (problem.domain.size() != count) throw std::logic_error("one range for each variable");
  for (const Condition& condition : problem.conditions) {
    auto affine = affine_form(condition.body, count);
    auto directions = directions_of(condition, affine, count);
    conditions_.push_back({Formula(condition.body), std::move(affine), std::move(directions)});
  }
  if (problem.goal.enclosure) enclosure_.emplace(*problem.goal.enclosure);
}

bool Judge::refutes(std::size_t index, const Box& box) const {
  const Ready& ready = conditions_[index];
  thread_local std::vector<Interval> best;
  best.resize(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    // Where the body is monotone its greatest value lies at one end.
    const Interval range = box[i].interval();
    best[i] = ready.directions[i] == Direction::kGrows   ? Interval(range.upper)
              : ready.directions[i] == Direction::kFalls ? Interval(range.lower)
                                                         : range;
  }
  const Interval greatest = ready.affine ? ready.affine->over(box) : ready.body.over(best);
  return condition(index).strict ? greatest.upper <= 0.0 : greatest.upper < 0.0;
}

bool Judge::holds(std::size_t index, std::span<const std::int64_t> point) const {
  const Interval value = conditions_[index].body.at(point);
  if (value.lower > 0.0) return true;
  if (value.upper < 0.0) return false;
  const PreciseInterval precise = conditions_[index].body.precisely_at(point);
  if (precise.is_nowhere() || precise.is_negative()) return false;
  return precise.is_positive() || !condition(index).strict;
}

bool Judge::is_feasible(std::span<const std::int64_t> point) const {
  for (const Predicate& predicate : problem_.predicates) {
    if (!predicate.holds(point)) return false;
  }
  for (std::size_t i = 0; i < conditions_.size(); ++i) {
    if (!holds(i, point)) return false;
  }
  return true;
}

Interval Judge::cost_over(const Box& box) const {
  thread_local std::vector<Interval> ranges;
  ranges.resize(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) ranges[i] = box[i].interval();
  Interval value = value_.over(ranges);
  if (std::isnan(value.lower)) value = {-kInfinity, kInfinity};
  if (enclosure_) {
    const Interval common = intersect(value, enclosure_->over(ranges));
    if (!std::isnan(common.lower)) value = common;
  }
  return signed_cost(value, problem_.goal.maximise);
}

Interval Judge::cost_around(std::span<const std::int64_t> point) const {
  const Interval cost = signed_cost(value_.at(point), problem_.goal.maximise);
  return std::isnan(cost.lower) ? Interval{-kInfinity, kInfinity} : cost;
}

PreciseInterval Judge::cost_at(std::span<const std::int64_t> point) const {
  const PreciseInterval value = value_.precisely_at(point);
  return problem_.goal.maximise ? -value : value;
}

int Judge::compare(const PreciseInterval& a, const PreciseInterval& b) const {
  const PreciseInterval difference = a - b;
  if (!has_exact_cost()) {
    const double size = std::max(std::abs(a.nearest()), std::abs(b.nearest()));
    if (std::abs(difference.nearest()) <= kTieRelative * size) return 0;
  }
  return difference.is_negative() ? -1 : difference.is_positive() ? 1 : 0;
}

double Judge::ceiling(const PreciseInterval& cost) const {
  const double upper = cost.outward().upper;
  return has_exact_cost() ? upper : upper + 2.0 * kTieRelative * std::abs(upper);
}

double Judge::floor(const PreciseInterval& cost) const {
  const double lower = cost.outward().lower;
  return has_exact_cost() ? lower : lower - 2.0 * kTieRelative * std::abs(lower);
}

}  // namespace torquewright::optimization
