// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/least_minima.hpp"

#include <algorithm>
#include <set>
#include <span>

namespace torquewright::gearbox {
namespace {

using Minima = std::vector<std::int64_t>;

// Extends `chosen` gear by gear; the last gear's minimum follows from the designs still left.
class Finder {
 public:
  explicit Finder(const std::vector<std::int64_t>& own) : own_(own) {}

  std::vector<Minima> run(const std::vector<const BetterDesign*>& better) {
    extend({}, better);
    std::vector<Minima> least;
    for (const Minima& minima : found_) {
      const bool is_beaten = std::any_of(found_.begin(), found_.end(), [&](const Minima& other) {
        return other != minima && std::equal(other.begin(), other.end(), minima.begin(),
                                             [](auto a, auto b) { return a <= b; });
      });
      if (!is_beaten) least.push_back(minima);
    }
    return least;
  }

 private:
  void extend(const Minima& chosen, const std::vector<const BetterDesign*>& left) {
    const std::size_t gear = chosen.size();
    std::set<std::int64_t> candidates{0};
    for (const BetterDesign* design : left) {
      const std::int64_t excluding = design->free_teeth[gear] + 1;
      if (excluding <= own_[gear]) candidates.insert(excluding);
    }
    if (gear + 1 == own_.size()) {
      // The greatest candidate excludes all that this gear can exclude; none may remain.
      const std::int64_t needed = left.empty() ? 0 : *candidates.rbegin();
      if (without(left, gear, needed).empty()) found_.insert(with(chosen, needed));
      return;
    }
    for (const std::int64_t minimum : candidates) {
      extend(with(chosen, minimum), without(left, gear, minimum));
    }
  }

  static Minima with(Minima chosen, std::int64_t minimum) {
    chosen.push_back(minimum);
    return chosen;
  }

  static std::vector<const BetterDesign*> without(const std::vector<const BetterDesign*>& designs,
                                                  std::size_t gear, std::int64_t minimum) {
    std::vector<const BetterDesign*> left;
    std::copy_if(designs.begin(), designs.end(), std::back_inserter(left),
                 [&](const BetterDesign* design) { return design->free_teeth[gear] >= minimum; });
    return left;
  }

  const std::vector<std::int64_t>& own_;
  std::set<Minima> found_;
};

}  // namespace

std::vector<OptimalWhen> optimal_when(const std::vector<std::int64_t>& free_teeth,
                                      double clearance_rad, std::vector<BetterDesign> better) {
  if (clearance_rad < 0.0) return {};
  std::sort(better.begin(), better.end(), [](const BetterDesign& a, const BetterDesign& b) {
    return a.clearance_rad < b.clearance_rad;
  });
  std::vector<OptimalWhen> ranges;
  double above = 0.0;
  for (std::size_t excluded = 0; ranges.empty() || above < clearance_rad; ++excluded) {
    // alpha_min just above the clearance of the first `excluded` designs leaves the others.
    const bool is_last = excluded == better.size();
    const double up_to =
        is_last ? clearance_rad : std::min(better[excluded].clearance_rad, clearance_rad);
    if (!is_last && up_to <= above && !(ranges.empty() && up_to == 0.0)) continue;
    std::vector<const BetterDesign*> left;
    for (std::size_t i = excluded; i < better.size(); ++i) left.push_back(&better[i]);
    auto minima = Finder(free_teeth).run(left);
    if (!ranges.empty() && ranges.back().least_minima == minima) {
      ranges.back().clearance_up_to_rad = up_to;
    } else {
      ranges.push_back({above, up_to, ranges.empty(), std::move(minima)});
    }
    above = up_to;
  }
  return ranges;
}

}  // namespace torquewright::gearbox
