// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimization/discrete/judge.hpp"
#include "optimization/discrete/proof_tree.hpp"
#include "optimization/expressions/concave.hpp"

namespace torquewright::optimization {

/// One condition on a box, relaxed: h(x) >= 0 with h concave.
struct RelaxedCondition {
  std::size_t condition;
  ConcaveForm form;
  double scale;  ///< Largest |h| on the box, by which the solver scales; > 0.
};

/// A convex problem whose feasible points include all of a box's: every condition that is judged on
/// boxes, relaxed, and a concave function that is nowhere below minus the cost.
struct Relaxation {
  Box box;
  std::vector<RelaxedCondition> conditions;
  ConcaveForm gain;   ///< Concave function >= -cost.
  double gain_scale;  ///< Range of `gain` over the box; > 0.
  /// Number of conditions of the problem. Parts of the box may relax more of them than the box.
  std::size_t condition_count;
};

Relaxation relax_box(const Judge& judge, const Box& box);

/// Whether relaxations of this problem know a shape of its cost. Where they do not, intervals bound
/// the cost as well, and a solve can only combine conditions.
bool has_shape(const Judge& judge);

/// A sum of relaxed conditions, linearised at a point: the source of a dual bound.
struct DualPoint {
  std::vector<double> point;  ///< Inside the box.
  /// Multipliers by condition of the problem; >= 0, zero where it is not relaxed.
  std::vector<double> multipliers;
};

/// What a dual point proves about a box. Any point and any multipliers give valid numbers: negative
/// or non-finite multipliers count as zero. So whatever a solver returns, converged or not, yields
/// a true bound, if perhaps a useless one. Outward rounded.
struct DualBound {
  double least_cost;   ///< No point of the box that satisfies the conditions costs less.
  bool is_infeasible;  ///< No point of the box satisfies the conditions.
};
DualBound dual_bound(const Relaxation& relaxation, const DualPoint& dual);

/// Asks Ipopt for a good dual point. Its status is not used. Stops as soon as a dual point shows
/// that nothing in the box costs `ceiling` or less, or when the bound is about as good as it gets.
DualPoint solve(const Relaxation& relaxation, double ceiling);

}  // namespace torquewright::optimization
