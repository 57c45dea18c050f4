// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/need.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/bracketed_search.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kNeedTolerance = 1e-9;  // of what is sought
// Factors up to kGreatestChange, evenly by their logarithm, and ratios for each such span, that are
// tried before the least of them is bisected: each a region. What helps over less than one of these
// steps is not found.
constexpr int kFactorsTried = 240;
constexpr int kRatiosTried = 240;

/// Distance of the torque to the nearer bound; negative outside, but not by what rounding may miss.
/// Minus infinity in an empty range.
double margin_Nm(const JointRange& range, double torque_Nm) {
  if (range.is_empty) return -kUnlimited;
  const double margin =
      std::min(range.greatest.torque_Nm - torque_Nm, torque_Nm - range.least.torque_Nm);
  return std::abs(margin) <= kNeedTolerance * std::abs(torque_Nm) ? 0.0 : margin;
}

double margin_Nm(const Actuator& actuator, const OperatingConditions& conditions,
                 const Need& need) {
  return margin_Nm(range_at(actuator, conditions, need.speed_rad_s), need.torque_Nm);
}

using ShouldStop = std::function<bool()>;

/// The least of `change` from 1 to kGreatestChange at which the margin is not negative, looked for
/// in small steps: more may be too much (a pack's greatest voltage leaves no room to brake).
/// `likely` is tried too, so that a window that ends there is not stepped over.
template <typename Margin>
std::optional<double> least_factor(const Margin& margin, const ShouldStop& should_stop,
                                   double likely = kGreatestChange) {
  std::vector<double> factors;
  for (int i = 1; i <= kFactorsTried; ++i) {
    factors.push_back(std::pow(kGreatestChange, static_cast<double>(i) / kFactorsTried));
  }
  if (likely > 1.0 && likely < kGreatestChange) factors.push_back(likely);
  std::sort(factors.begin(), factors.end());
  double before = 1.0;
  for (const double factor : factors) {
    if (should_stop()) return std::nullopt;
    if (margin(factor) >= 0.0) return last_nonnegative(margin, factor, before, kNeedTolerance);
    before = factor;
  }
  return std::nullopt;
}

std::optional<double> least_voltage_V(const Actuator& actuator, OperatingConditions conditions,
                                      const Need& need, const ShouldStop& should_stop) {
  const double present_V = open_circuit_voltage_V(actuator, conditions);
  conditions.state_of_charge.reset();
  const double greatest_V = actuator.battery ? actuator.battery->maximum_voltage_V : kUnlimited;
  const std::optional<double> factor = least_factor(
      [&](double change) {
        conditions.bus_voltage_V = change * present_V;
        return margin_Nm(actuator, conditions, need);
      },
      should_stop, greatest_V / present_V);
  if (!factor) return std::nullopt;
  return *factor * present_V;
}

/// Only where the gears' strength is stated.
std::optional<double> least_gear_Nm(const Actuator& actuator, const OperatingConditions& conditions,
                                    const Need& need, const ShouldStop& should_stop) {
  const double present_Nm = actuator.transmission.peak_torque_Nm;
  if (!(present_Nm < kUnlimited)) return std::nullopt;
  Actuator changed = actuator;
  const std::optional<double> factor = least_factor(
      [&](double change) {
        changed.transmission.peak_torque_Nm = change * present_Nm;
        return margin_Nm(changed, conditions, need);
      },
      should_stop);
  if (!factor) return std::nullopt;
  return *factor * present_Nm;
}

/// Current that heat allows is not for sale: under the continuous rating only where it is stated.
std::optional<double> least_current_A(const Actuator& actuator,
                                      const OperatingConditions& conditions, const Need& need,
                                      const ShouldStop& should_stop) {
  Actuator changed = actuator;
  const bool is_peak = conditions.rating == Rating::kPeak;
  const double present_A =
      is_peak ? actuator.drive.peak_current_A : actuator.drive.continuous_current_A.value_or(0.0);
  if (present_A == 0.0) return std::nullopt;
  const std::optional<double> factor = least_factor(
      [&](double change) {
        changed.drive.peak_current_A = std::max(actuator.drive.peak_current_A, change * present_A);
        if (!is_peak) changed.drive.continuous_current_A = change * present_A;
        return margin_Nm(changed, conditions, need);
      },
      should_stop);
  if (!factor) return std::nullopt;
  return *factor * present_A;
}

/// The nearest ratio (as a factor of the present one) either way: too low a ratio lacks torque, too
/// high a one lacks speed, and in between there may be none.
std::optional<double> nearest_ratio(const Actuator& actuator, const OperatingConditions& conditions,
                                    const Need& need, const ShouldStop& should_stop) {
  Actuator changed = actuator;
  const double present = actuator.transmission.ratio;
  const auto margin = [&](double logarithm) {
    changed.transmission.ratio = present * std::exp(logarithm);
    return margin_Nm(changed, conditions, need);
  };
  const double step = std::log(kGreatestChange) / kRatiosTried;
  for (int i = 1; i <= kRatiosTried && !should_stop(); ++i) {
    for (const double sign : {1.0, -1.0}) {
      const double there = sign * i * step;
      if (margin(there) < 0.0) continue;
      const double logarithm =
          last_nonnegative(margin, there, sign * (i - 1) * step, kNeedTolerance);
      return present * std::exp(logarithm);
    }
  }
  return std::nullopt;
}

RatioRow ratio_row(const Actuator& actuator, const OperatingConditions& conditions,
                   const std::optional<Need>& need) {
  const Region region(actuator, conditions);
  RatioRow row;
  row.ratio = actuator.transmission.ratio;
  row.driving = driving_figures(region);
  row.reflected_inertia_kg_m2 = actuator.transmission.inertia_kg_m2 +
                                row.ratio * row.ratio * actuator.motor.rotor_inertia_kg_m2;
  if (need) row.margin_Nm = margin_Nm(region.at(need->speed_rad_s), need->torque_Nm);
  return row;
}

}  // namespace

NeedAnswer answer_need(const Actuator& actuator, const OperatingConditions& conditions,
                       const Need& need, const ShouldStop& should_stop) {
  NeedAnswer result;
  result.range = range_at(actuator, conditions, need.speed_rad_s);
  result.margin_Nm = margin_Nm(result.range, need.torque_Nm);
  result.is_reached = result.margin_Nm >= 0.0;
  const bool is_upper =
      need.torque_Nm > 0.5 * (result.range.least.torque_Nm + result.range.greatest.torque_Nm);
  result.limiter = result.range.is_empty ? result.range.why_empty
                   : is_upper            ? result.range.greatest.limiter
                                         : result.range.least.limiter;
  if (result.is_reached) return result;
  if (actuator.envelope) {
    if (actuator.envelope->voltage_V) {
      result.least_bus_voltage_V = least_voltage_V(actuator, conditions, need, should_stop);
    }
    result.least_gear_Nm = least_gear_Nm(actuator, conditions, need, should_stop);
    result.nearest_ratio = nearest_ratio(actuator, conditions, need, should_stop);
    result.is_ended = should_stop();
    return result;
  }
  result.least_bus_voltage_V = least_voltage_V(actuator, conditions, need, should_stop);
  result.least_current_A = least_current_A(actuator, conditions, need, should_stop);
  result.least_gear_Nm = least_gear_Nm(actuator, conditions, need, should_stop);
  result.nearest_ratio = nearest_ratio(actuator, conditions, need, should_stop);
  result.is_ended = should_stop();
  return result;
}

std::vector<RatioRow> ratio_sweep(const Actuator& actuator, const OperatingConditions& conditions,
                                  double low, double high, std::size_t count,
                                  const std::optional<Need>& need) {
  Actuator changed = actuator;
  std::vector<RatioRow> rows;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1);
    const double ratio = i + 1 == count && count > 1 ? high : low * std::pow(high / low, share);
    changed.transmission.ratio = std::copysign(ratio, actuator.transmission.ratio);
    rows.push_back(ratio_row(changed, conditions, need));
  }
  return rows;
}

}  // namespace torquewright::actuator
