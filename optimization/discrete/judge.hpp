// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "optimization/discrete/problem.hpp"
#include "optimization/expressions/affine.hpp"
#include "optimization/expressions/formula.hpp"

namespace torquewright::optimization {

/// Two values of a goal with roots or angles that differ by less than this count as equal.
inline constexpr double kTieRelative = 1e-12;

/// A problem prepared for many questions: which boxes and points satisfy which condition, and what
/// a point costs at least. A cost is the goal's value, with its sign turned where it is maximised,
/// so that less is better. All answers are rigorous.
class Judge {
 public:
  explicit Judge(const Problem& problem);

  std::size_t condition_count() const { return conditions_.size(); }
  const Condition& condition(std::size_t index) const { return problem_.conditions[index]; }
  const Problem& problem() const { return problem_; }
  bool on_boxes(std::size_t index) const { return problem_.conditions[index].on_boxes; }
  const std::optional<Affine>& affine(std::size_t index) const { return conditions_[index].affine; }

  /// Whether the condition holds nowhere in the box.
  bool refutes(std::size_t index, const Box& box) const;
  /// Whether the condition holds at a point. Exact: doubtful cases are decided with 256 bits.
  bool holds(std::size_t index, std::span<const std::int64_t> point) const;
  /// Whether a point satisfies all conditions and predicates.
  bool is_feasible(std::span<const std::int64_t> point) const;

  /// Encloses the cost of every point of the box that satisfies all conditions. -infinity below
  /// where nothing is known.
  Interval cost_over(const Box& box) const;
  /// The cost of one point, enclosed in doubles and in 256 bits. -infinity below where it does not
  /// exist.
  Interval cost_around(std::span<const std::int64_t> point) const;
  PreciseInterval cost_at(std::span<const std::int64_t> point) const;
  bool has_exact_cost() const { return problem_.goal.exact; }

  /// Compares costs: -1, 0, 1 where a is better than, as good as, worse than b.
  int compare(const PreciseInterval& a, const PreciseInterval& b) const;
  /// Returns the least double that no cost as good as this one exceeds.
  double ceiling(const PreciseInterval& cost) const;
  /// Returns the greatest double below which every cost is better than this one.
  double floor(const PreciseInterval& cost) const;

 private:
  struct Ready {
    Formula body;
    std::optional<Affine> affine;
    std::vector<Direction> directions;
  };
  Problem problem_;
  std::vector<Ready> conditions_;
  Formula value_;
  std::optional<Formula> enclosure_;
};

}  // namespace torquewright::optimization
