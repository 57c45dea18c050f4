// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/winding_heat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::actuator {
namespace {

/// Where a state ends that the step is taken for ever from, if it does: x = (1 - map)^-1 shift.
std::optional<Warmth> fixed_point(const HeatStep& step) {
  const auto& [a, b, c, d] = step.map;
  const double determinant = (1.0 - a) * (1.0 - d) - b * c;
  // A non-negative matrix is a contraction just when 1 - map has positive leading minors.
  if (!(1.0 - a > 0.0 && determinant > 0.0)) return std::nullopt;
  return Warmth{((1.0 - d) * step.shift[0] + b * step.shift[1]) / determinant,
                (c * step.shift[0] + (1.0 - a) * step.shift[1]) / determinant};
}

/// Heat that no number holds is without bound: maps and shifts are not negative, so that nothing
/// else makes what is no number.
Warmth without_nan(Warmth warmth) {
  for (double& each_K : warmth) {
    if (std::isnan(each_K)) each_K = std::numeric_limits<double>::infinity();
  }
  return warmth;
}

/// The least number from 1 to `most` that satisfies a condition which, once true, stays true.
template <typename Condition>
std::optional<std::size_t> first_number(std::size_t most, const Condition& holds) {
  if (!holds(most)) return std::nullopt;
  std::size_t low = 0;
  std::size_t high = most;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (holds(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

void WindingHeat::add(double square_A2, double duration_s) {
  const HeatStep step = model_.step(square_A2, duration_s);
  if (!blocks_.empty() && steps_in_last_ < steps_a_block_) {
    blocks_.back() = then(blocks_.back(), step);
    ++steps_in_last_;
    return;
  }
  if (blocks_.size() == kMostBlocks) {
    for (std::size_t i = 0; i < kMostBlocks / 2; ++i) {
      blocks_[i] = then(blocks_[2 * i], blocks_[2 * i + 1]);
    }
    blocks_.resize(kMostBlocks / 2);
    steps_a_block_ *= 2;
  }
  blocks_.push_back(step);
  steps_in_last_ = 1;
}

WindingHeat::Course WindingHeat::run(Warmth warmth) const {
  warmth = without_nan(warmth);
  double coldest_K = warmth[0];
  double warmest_K = warmth[0];
  for (const HeatStep& block : blocks_) {
    warmth = without_nan(block.after(warmth));
    coldest_K = std::min(coldest_K, warmth[0]);
    warmest_K = std::max(warmest_K, warmth[0]);
  }
  return {coldest_K, warmest_K, warmth};
}

HeatStep WindingHeat::whole() const {
  HeatStep all;
  for (const HeatStep& block : blocks_) all = then(all, block);
  return all;
}

/// The state in which run number `index` (from 0) starts, by doubling.
Warmth WindingHeat::start_of_run(std::size_t index, double pause_s) const {
  HeatStep power = whole();
  if (pause_s > 0.0) power = then(power, model_.step(0.0, pause_s));
  Warmth warmth{0.0, 0.0};
  for (; index > 0; index /= 2, power = then(power, power)) {
    if (index % 2 == 1) warmth = power.after(warmth);
  }
  return warmth;
}

WindingReport WindingHeat::report(std::size_t runs, double pause_s) const {
  const double ambient_K = model_.ambient_K();
  // Runs only get warmer: they start at the ambient, and every map is non-negative. Eq. (7).
  const auto peak_K = [&](std::size_t number) {
    return ambient_K + run(start_of_run(number - 1, pause_s)).warmest_K;
  };
  WindingReport report;
  report.limit_K = model_.limit_K();
  report.runs = runs;
  report.first_peak_K = peak_K(1);
  const Course last = run(start_of_run(runs - 1, pause_s));
  report.peak_K = ambient_K + last.warmest_K;
  report.coldest_K = ambient_K + last.coldest_K;
  report.end_K = ambient_K + last.end[0];
  report.resolution_s = steps_a_block_ == 1 || blocks_.empty() ? 0.0 : blocks_.front().duration_s;
  HeatStep cycle = whole();
  if (pause_s > 0.0) cycle = then(cycle, model_.step(0.0, pause_s));
  if (const std::optional<Warmth> steady = fixed_point(cycle)) {
    const double steady_K = ambient_K + run(*steady).warmest_K;
    report.steady_peak_K = steady_K;
    report.runs_to_steady = first_number(
        kMostRuns, [&](std::size_t number) { return peak_K(number) >= steady_K - kSteady_K; });
  }
  report.runs_to_limit = first_number(
      kMostRuns, [&](std::size_t number) { return !(peak_K(number) <= report.limit_K); });
  return report;
}

}  // namespace torquewright::actuator
