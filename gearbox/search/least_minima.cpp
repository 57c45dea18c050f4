// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/least_minima.hpp"

#include <algorithm>
#include <set>

namespace torquewright::gearbox {
namespace {

using Teeth = std::vector<std::int64_t>;

bool is_nowhere_less(const Teeth& a, const Teeth& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](auto x, auto y) { return x >= y; });
}

// Whatever excludes `a` excludes `b`.
bool is_harder_to_exclude(const TeethAndClearance& a, const TeethAndClearance& b) {
  return a.clearance_rad >= b.clearance_rad && is_nowhere_less(a.free_teeth, b.free_teeth);
}

// The least minima that exclude a growing number of designs and not the one in question.
class LeastMinima {
 public:
  explicit LeastMinima(const Teeth& own) : own_(own), least_{Teeth(own.size(), 0)} {}

  // Minima that leave the design in grow in one gear to one more than its teeth.
  void exclude(const Teeth& design) {
    std::set<Teeth> grown;
    for (auto minima = least_.begin(); minima != least_.end();) {
      if (!is_nowhere_less(design, *minima)) {
        ++minima;
        continue;
      }
      for (std::size_t gear = 0; gear < own_.size(); ++gear) {
        if (design[gear] >= own_[gear]) continue;
        Teeth more = *minima;
        more[gear] = design[gear] + 1;
        grown.insert(std::move(more));
      }
      minima = least_.erase(minima);
    }
    least_.merge(grown);
    keep_least();
  }

  std::vector<Teeth> all() const { return {least_.begin(), least_.end()}; }

 private:
  void keep_least() {
    std::erase_if(least_, [&](const Teeth& minima) {
      return std::any_of(least_.begin(), least_.end(), [&](const Teeth& other) {
        return &other != &minima && is_nowhere_less(minima, other);
      });
    });
  }

  const Teeth& own_;
  std::set<Teeth> least_;
};

}  // namespace

void BetterDesigns::add(TeethAndClearance better) {
  if (better.clearance_rad < 0.0) return;  // any alpha_min excludes it
  // No minimum exceeds the design's own teeth, and no alpha_min its clearance.
  better.clearance_rad = std::min(better.clearance_rad, own_.clearance_rad);
  for (std::size_t gear = 0; gear < own_.free_teeth.size(); ++gear) {
    better.free_teeth[gear] = std::min(better.free_teeth[gear], own_.free_teeth[gear]);
  }
  const auto settles = [&](const TeethAndClearance& known) {
    return is_harder_to_exclude(known, better);
  };
  if (std::any_of(hardest_.begin(), hardest_.end(), settles)) return;
  std::erase_if(hardest_, [&](const TeethAndClearance& known) {
    return is_harder_to_exclude(better, known);
  });
  hardest_.push_back(std::move(better));
}

// From the design's own clearance downwards: the less alpha_min is, the more designs are left that
// minima have to exclude.
std::vector<OptimalWhen> BetterDesigns::optimal_when() const {
  if (own_.clearance_rad < 0.0) return {};
  std::vector<TeethAndClearance> left = hardest_;
  std::sort(left.begin(), left.end(),
            [](const auto& a, const auto& b) { return a.clearance_rad > b.clearance_rad; });
  std::vector<OptimalWhen> ranges;
  LeastMinima minima(own_.free_teeth);
  double up_to = own_.clearance_rad;
  for (auto next = left.begin();;) {
    for (; next != left.end() && next->clearance_rad >= up_to; ++next) {
      minima.exclude(next->free_teeth);
    }
    const bool is_last = next == left.end();
    const double above = is_last ? 0.0 : next->clearance_rad;
    if (!ranges.empty() && ranges.back().least_minima == minima.all()) {
      ranges.back().clearance_above_rad = above;
      ranges.back().from_zero = is_last;
    } else {
      ranges.push_back({above, up_to, is_last, minima.all()});
    }
    if (is_last) break;
    up_to = above;
  }
  std::reverse(ranges.begin(), ranges.end());
  return ranges;
}

}  // namespace torquewright::gearbox
