// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/trade_offs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

using Eigen::Index;
using Of = FreeValue::Of;

constexpr double kGainTold = 0.1;  ///< Of a gain: what it may be off and be printed as one.
/// A value correlated with another by more would have half its error if that were known.
constexpr double kTwiceAsWell = 0.866;

double correlation(const ValueFit& fit, std::size_t a, std::size_t b) {
  const auto i = static_cast<Index>(a), j = static_cast<Index>(b);
  const double both = std::sqrt(fit.covariance(i, i) * fit.covariance(j, j));
  return both > 0.0 ? fit.covariance(i, j) / both : 0.0;
}

TradedValue traded(const ValueFit& fit, std::size_t k, std::size_t first) {
  const FittedValue& own = fit.values[k];
  TradedValue one{own.which, own.value, own.standard_error, 1.0, 0.0};
  const double base = fit.values[first].value;
  if (k == first || base == 0.0) return one;
  const auto i = static_cast<Index>(k), j = static_cast<Index>(first);
  one.ratio = own.value / base;
  const double variance = fit.covariance(i, i) - 2.0 * one.ratio * fit.covariance(i, j) +
                          one.ratio * one.ratio * fit.covariance(j, j);
  one.ratio_error = std::sqrt(std::max(0.0, variance)) / std::abs(base);
  return one;
}

/// What is proportional to a gain at equal motion.
bool may_scale(const FreeValue& which) {
  return which.of == Of::kRotor || which.of == Of::kEffect || which.of == Of::kDamping ||
         which.of == Of::kWave;
}

void add_scales(ValueFit& fit, std::vector<TradeOff>& found) {
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    const FittedValue& gain = fit.values[k];
    if (gain.which.of != Of::kStiffness || gain.is_at_bound) continue;
    if (gain.standard_error < kGainTold * std::abs(gain.value)) continue;
    TradeOff one{gain.which.joint, true, {traded(fit, k, k)}};
    for (std::size_t j = 0; j < fit.values.size(); ++j) {
      const FreeValue& which = fit.values[j].which;
      if (which.joint != gain.which.joint || !may_scale(which)) continue;
      if (correlation(fit, k, j) < kTwiceAsWell) continue;
      one.values.push_back(traded(fit, j, k));
      fit.values[j].is_traded = true;
    }
    fit.values[k].is_traded = true;
    found.push_back(std::move(one));
  }
}

/// Pairs of which neither is told, and each would be better known with the other.
void add_pairs(ValueFit& fit, std::vector<TradeOff>& found) {
  std::vector<bool> is_in(fit.values.size(), false);
  for (std::size_t k = 0; k < fit.values.size(); ++k) is_in[k] = fit.values[k].is_traded;
  for (std::size_t a = 0; a < fit.values.size(); ++a) {
    if (is_in[a] || fit.values[a].is_told() || fit.values[a].is_at_bound) continue;
    for (std::size_t b = 0; b < fit.values.size(); ++b) {
      const FreeValue& one = fit.values[a].which;
      const FreeValue& other = fit.values[b].which;
      const bool is_of_one = other.is_of_all() || one.is_of_all() || one.joint == other.joint;
      if (a == b || is_in[b] || !is_of_one || fit.values[b].is_at_bound) continue;
      if (std::abs(correlation(fit, a, b)) < kTwiceAsWell) continue;
      const std::size_t joint = one.is_of_all() ? other.joint : one.joint;
      found.push_back({joint, false, {traded(fit, a, a), traded(fit, b, a)}});
      fit.values[a].is_traded = fit.values[b].is_traded = is_in[a] = is_in[b] = true;
      break;
    }
  }
}

}  // namespace

std::vector<TradeOff> find_trade_offs(ValueFit& fit) {
  std::vector<TradeOff> found;
  if (fit.values.empty() || fit.covariance.size() == 0) return found;
  for (FittedValue& each : fit.values) each.is_traded = false;
  add_scales(fit, found);
  add_pairs(fit, found);
  return found;
}

std::string separated_by(const TradeOff& trade_off) {
  if (trade_off.is_scale) {
    return "a known load that the joint lifts, or the size of its current with a known torque "
           "constant";
  }
  return "motion in which one acts without the other: both directions, several speeds, the whole "
         "range";
}

std::string sentence_of(const TradeOff& trade_off, const std::vector<std::string>& joints) {
  const std::string& joint = joints[trade_off.joint];
  const TradedValue& first = trade_off.values.front();
  std::string text = fmt::format("{}: {} ({:.2g} ± {:.1g})", joint, first.which.name, first.value,
                                 first.standard_error);
  if (!trade_off.is_scale) {
    const TradedValue& other = trade_off.values.back();
    return fmt::format("{} and {} ({:.2g} ± {:.1g}) stand for each other: the log cannot tell.",
                       text, other.which.name, other.value, other.standard_error);
  }
  if (trade_off.values.size() == 1) return text + " is not told by the log.";
  std::string names, ratios;
  for (std::size_t i = 1; i < trade_off.values.size(); ++i) {
    const TradedValue& each = trade_off.values[i];
    const bool is_last = i + 1 == trade_off.values.size();
    names += (is_last ? " and " : ", ") + each.which.name;
    ratios += fmt::format("{}{} {:.2g} ± {:.1g}", ratios.empty() ? "" : ", ", each.which.name,
                          each.ratio, each.ratio_error);
  }
  return fmt::format(
      "{}{} scale together without changing the motion: the log tells none of them, only their "
      "ratios "
      "to the gain: {}. {} would tell.",
      text, names, ratios, "A" + separated_by(trade_off).substr(1));
}

}  // namespace torquewright::identification
