// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "optimization/discrete/judge.hpp"

namespace torquewright::optimization {

/// A feasible point of one of the alternatives.
struct Solution {
  std::size_t alternative = 0;
  std::vector<std::int64_t> point;
  PreciseInterval cost;
};

/// The best points found so far, best first; points of one cost in the order of alternatives and
/// values, so that the list does not depend on the order of finding. It holds every point that
/// counts as good as the last wanted one (Judge::compare), so it may be longer than `wanted`.
class Incumbents {
 public:
  Incumbents(const Judge& judge, std::size_t wanted) : judge_(judge), wanted_(wanted) {}

  void offer(Solution solution);
  const std::vector<Solution>& solutions() const { return solutions_; }
  /// The cost above which a point is not kept; infinite as long as fewer than `wanted` are known.
  double ceiling() const { return ceiling_; }

 private:
  const Judge& judge_;
  std::size_t wanted_;
  std::vector<Solution> solutions_;
  double ceiling_ = std::numeric_limits<double>::infinity();
};

}  // namespace torquewright::optimization
