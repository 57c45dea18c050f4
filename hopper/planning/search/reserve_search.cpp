// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/search/reserve_search.hpp"

#include <algorithm>
#include <utility>

#include "hopper/planning/tasks/reserve.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kStep = 0.04;
constexpr double kSame = 1e-9;

class ReserveSearch {
 public:
  explicit ReserveSearch(const ReserveTrials& trials) : trials_(trials) {}

  ReserveChoice run(double least) {
    double end = least;
    while (try_one(end)) end += kStep;
    try_one(end - 0.5 * kStep);
    if (const auto best = chosen()) {
      const double middle = choice_.tried[*best].reserve;
      for (const double side : {-0.5, 0.5}) {
        if (middle + side * kStep > least) try_one(middle + side * kStep);
      }
    }
    choice_.chosen = chosen();
    return std::move(choice_);
  }

 private:
  /// Whether it has a plan; one that was tried is not tried again.
  bool try_one(double reserve) {
    if (reserve < -kSame || reserve > greatest_reserve()) return false;
    const bool is_first = choice_.tried.empty();  // whose answer there always is
    if (!is_first && trials_.should_stop && trials_.should_stop()) return false;
    const auto at = std::find_if(choice_.tried.begin(), choice_.tried.end(),
                                 [&](const auto& one) { return one.reserve > reserve - kSame; });
    if (at != choice_.tried.end() && at->reserve < reserve + kSame) return at->trials.has_value();
    TriedReserve tried{std::max(0.0, reserve), trials_.plan(std::max(0.0, reserve)), {}};
    const bool is_planned = tried.result.status == PlanStatus::kPlanned;
    if (is_planned) tried.trials = trials_.fare(tried.result);
    choice_.tried.insert(at, std::move(tried));
    return is_planned;
  }

  std::optional<std::size_t> chosen() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < choice_.tried.size(); ++i) {
      const auto& counts = choice_.tried[i].trials;
      if (!counts) continue;
      if (!best || counts->succeeded > choice_.tried[*best].trials->succeeded) best = i;
    }
    return best;
  }

  const ReserveTrials& trials_;
  ReserveChoice choice_;
};

}  // namespace

ReserveChoice search_reserve(double least, const ReserveTrials& trials) {
  return ReserveSearch(trials).run(least);
}

}  // namespace torquewright::hopper
