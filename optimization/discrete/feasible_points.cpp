// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "optimization/discrete/branch_and_bound.hpp"
#include "optimization/discrete/branching.hpp"
#include "optimization/discrete/enumeration.hpp"
#include "optimization/discrete/propagation.hpp"

namespace torquewright::optimization {
namespace {

constexpr std::int64_t kBoxesBetweenReports = 512;

bool costs_too_much(const Judge& judge, std::span<const std::int64_t> point, double ceiling) {
  return std::isfinite(ceiling) && judge.cost_around(point).lower > ceiling;
}

}  // namespace

VisitStatus for_each_feasible(
    std::span<const Judge> alternatives, const VisitOptions& options,
    const std::function<bool(std::size_t, std::span<const std::int64_t>)>& visit) {
  std::int64_t boxes = 0;
  std::vector<Cut> unused;
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    const Judge& judge = alternatives[i];
    std::vector<Box> open{judge.problem().domain};
    bool goes_on = true;
    while (!open.empty()) {
      if (++boxes > options.max_boxes || options.should_stop()) return VisitStatus::kLimit;
      if (boxes % kBoxesBetweenReports == 0) options.report(boxes);
      Box box = std::move(open.back());
      open.pop_back();
      unused.clear();
      if (point_count(box) == 0.0 || propagate(judge, options.ceiling, box, unused)) continue;
      if (!is_small(box)) {
        const Split split = choose_split(box);
        open.push_back(second_half(box, split));
        open.push_back(first_half(std::move(box), split));
        continue;
      }
      for_each_point(box, [&](std::span<const std::int64_t> point) {
        if (goes_on && costs_too_much(judge, point, options.ceiling)) return;
        if (goes_on && judge.is_feasible(point)) goes_on = visit(i, point);
      });
      if (!goes_on) return VisitStatus::kStopped;
    }
  }
  return VisitStatus::kAll;
}

}  // namespace torquewright::optimization
