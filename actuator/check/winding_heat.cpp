// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/winding_heat.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

std::array<double, 4> product(const std::array<double, 4>& left,
                              const std::array<double, 4>& right) {
  return {left[0] * right[0] + left[1] * right[2], left[0] * right[1] + left[1] * right[3],
          left[2] * right[0] + left[3] * right[2], left[2] * right[1] + left[3] * right[3]};
}

/// (e^x - 1) / x.
double mean_exponential(double x) { return std::abs(x) < 1e-12 ? 1.0 : std::expm1(x) / x; }

/// Where a state ends that the step is taken for ever from, if it does: x = (1 - map)^-1 shift.
std::optional<Warmth> fixed_point(const HeatStep& step) {
  const auto& [a, b, c, d] = step.map;
  const double determinant = (1.0 - a) * (1.0 - d) - b * c;
  // A non-negative matrix is a contraction just when 1 - map has positive leading minors.
  if (!(1.0 - a > 0.0 && determinant > 0.0)) return std::nullopt;
  return Warmth{((1.0 - d) * step.shift[0] + b * step.shift[1]) / determinant,
                (c * step.shift[0] + (1.0 - a) * step.shift[1]) / determinant};
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

Warmth HeatStep::after(const Warmth& warmth) const {
  return {map[0] * warmth[0] + map[1] * warmth[1] + shift[0],
          map[2] * warmth[0] + map[3] * warmth[1] + shift[1]};
}

HeatStep then(const HeatStep& first, const HeatStep& second) {
  return {product(second.map, first.map), second.after(first.shift),
          first.duration_s + second.duration_s};
}

HeatModel::HeatModel(const Actuator& actuator, const OperatingConditions& conditions)
    : thermal_(*actuator.thermal) {
  // The resistance is linear in the temperature: two places tell it.
  const auto resistance_ohm = [&](double temperature_K) {
    OperatingConditions changed = conditions;
    changed.winding_temperature_K = temperature_K;
    return phase_model_at(actuator, changed).resistance_ohm;
  };
  constexpr double kSpan_K = 100.0;
  resistance_ohm_ = resistance_ohm(thermal_.ambient_K);
  resistance_ohm_per_K_ =
      (resistance_ohm(thermal_.ambient_K + kSpan_K) - resistance_ohm_) / kSpan_K;
}

HeatStep HeatModel::step(double square_A2, double duration_s) const {
  // x' = M x + c, x the warmth: eq. (5).
  const double winding_1_s = 1.0 / (thermal_.winding_to_case_K_W * thermal_.winding_J_K);
  const double case_1_s = 1.0 / (thermal_.winding_to_case_K_W * thermal_.case_J_K);
  const double ambient_1_s = 1.0 / (thermal_.case_to_ambient_K_W * thermal_.case_J_K);
  const double growth_1_s = 1.5 * square_A2 * resistance_ohm_per_K_ / thermal_.winding_J_K;
  const double heating_K_s = 1.5 * square_A2 * resistance_ohm_ / thermal_.winding_J_K;
  const double m11 = growth_1_s - winding_1_s;
  const double m12 = winding_1_s;
  const double m21 = case_1_s;
  const double m22 = -case_1_s - ambient_1_s;
  // Both eigenvalues are real, since m12 m21 > 0: eq. (6).
  const double middle_1_s = 0.5 * (m11 + m22);
  const double half_1_s = std::hypot(0.5 * (m11 - m22), std::sqrt(m12 * m21));
  const double slow = (middle_1_s + half_1_s) * duration_s;
  const double fast = (middle_1_s - half_1_s) * duration_s;
  // exp(M t) = f0 + f1 M and its integral over t, g0 + g1 M, by their values at the eigenvalues.
  const double f1 = (std::exp(slow) - std::exp(fast)) / (2.0 * half_1_s);
  const double f0 = std::exp(slow) - f1 * (middle_1_s + half_1_s);
  const double g_slow = duration_s * mean_exponential(slow);
  const double g1 = (g_slow - duration_s * mean_exponential(fast)) / (2.0 * half_1_s);
  const double g0 = g_slow - g1 * (middle_1_s + half_1_s);
  return {{f0 + f1 * m11, f1 * m12, f1 * m21, f0 + f1 * m22},
          {(g0 + g1 * m11) * heating_K_s, g1 * m21 * heating_K_s},
          duration_s};
}

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

WindingHeat::Peak WindingHeat::run(Warmth warmth) const {
  double warmest_K = warmth[0];
  for (const HeatStep& block : blocks_) {
    warmth = block.after(warmth);
    warmest_K = std::max(warmest_K, warmth[0]);
  }
  return {warmest_K, warmth};
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
  report.peak_K = peak_K(runs);
  report.end_K = ambient_K + run(start_of_run(runs - 1, pause_s)).end[0];
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
