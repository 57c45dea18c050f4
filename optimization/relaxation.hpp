// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimization/concave.hpp"
#include "optimization/judge.hpp"
#include "optimization/proof_tree.hpp"

namespace torquewright::optimization {

/// One condition on a box, relaxed: h(x) >= 0 with h concave.
struct RelaxedCondition {
  std::size_t condition;  ///< kQuantity: ceiling - cost.
  ConcaveForm form;
  double scale;           ///< Largest |h| on the box, for the solver's sake; > 0.
};

/// All conditions that are judged on boxes, relaxed on this one, and the cost's ceiling if finite.
std::vector<RelaxedCondition> relax_conditions(const Judge& judge, double ceiling, const Box& box);

/// A sum of relaxed conditions, linearised at a point.
struct Refutation {
  std::vector<double> point;
  std::vector<double> multipliers;  ///< One for each relaxed condition, >= 0.
};

/// Upper bound, by outward-rounded arithmetic, of the linearised sum over the box. Below zero: no
/// point of the box satisfies all conditions. Any point in the box and any multipliers are allowed:
/// negative or non-finite ones count as zero, so whatever a solver returns gives a valid bound.
double greatest_sum(const std::vector<RelaxedCondition>& conditions, const Box& box,
                    const Refutation& refutation);

/// What Ipopt found out about a relaxed box.
struct RelaxationResult {
  std::optional<Refutation> refutation;  ///< Proved by greatest_sum, never by Ipopt's word.
  std::vector<double> point;             ///< Where it stopped: a start for rounding.
};

/// Asks Ipopt for the point of the box at which the worst relaxed condition is best. The search stops
/// as soon as its multipliers refute the box, or its point satisfies every relaxed condition.
/// Ipopt's own status is not used: a failed solve yields no refutation, which costs time only.
RelaxationResult solve_relaxation(const std::vector<RelaxedCondition>& conditions, const Box& box);

}  // namespace torquewright::optimization
