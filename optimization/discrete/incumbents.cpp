// SPDX-License-Identifier: Apache-2.0
#include "optimization/discrete/incumbents.hpp"

#include <algorithm>
#include <tuple>

namespace torquewright::optimization {

namespace {

// Not Judge::compare, whose ties are no order: of three costs the outer two may differ by more than
// a tie although each equals the middle one.
bool precedes(const Solution& a, const Solution& b) {
  const PreciseInterval difference = a.cost - b.cost;
  if (difference.is_negative()) return true;
  if (difference.is_positive()) return false;
  return std::tie(a.alternative, a.point) < std::tie(b.alternative, b.point);
}

}  // namespace

void Incumbents::offer(Solution solution) {
  const auto is_same = [&](const Solution& known) {
    return known.alternative == solution.alternative && known.point == solution.point;
  };
  if (std::any_of(solutions_.begin(), solutions_.end(), is_same)) return;
  auto place = solutions_.end();
  while (place != solutions_.begin() && precedes(solution, *std::prev(place))) --place;
  solutions_.insert(place, std::move(solution));
  if (solutions_.size() < wanted_) return;
  const PreciseInterval last = solutions_[wanted_ - 1].cost;
  while (judge_.compare(solutions_.back().cost, last) > 0) solutions_.pop_back();
  ceiling_ = judge_.ceiling(last);
}

}  // namespace torquewright::optimization
