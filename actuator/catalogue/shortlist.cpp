// SPDX-License-Identifier: Apache-2.0
#include "actuator/catalogue/shortlist.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/motor/limiter_words.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kRatioStep = 1.02;

/// Of one demand: what is there beyond it, and what to say where nothing is.
struct Answer {
  double share = 0.0;
  std::string reason;
};

/// What a range has for a torque, driving or braking.
double available_Nm(const JointRange& range, double torque_Nm) {
  if (range.is_empty) return 0.0;
  return torque_Nm >= 0.0 ? range.greatest.torque_Nm : -range.least.torque_Nm;
}

Answer answer(const Actuator& actuator, const Need& need) {
  const JointRange range = range_at(actuator, {}, need.speed_rad_s);
  const double wanted_Nm = std::abs(need.torque_Nm);
  const double there_Nm = available_Nm(range, need.torque_Nm);
  if (range.is_empty) {
    return {-1.0, fmt::format("no torque at {:.4g} rad/s ({})", need.speed_rad_s,
                              name_of(range.why_empty, actuator.battery.has_value()))};
  }
  const Limiter limiter = need.torque_Nm >= 0.0 ? range.greatest.limiter : range.least.limiter;
  return {wanted_Nm > 0.0 ? there_Nm / wanted_Nm - 1.0 : kUnlimited,
          fmt::format("{:.4g} of {:.4g} Nm at {:.4g} rad/s ({})", there_Nm, wanted_Nm,
                      need.speed_rad_s, name_of(limiter, actuator.battery.has_value()))};
}

Answer continuous_answer(const Actuator& actuator, double wanted_Nm) {
  const JointRange range = range_at(actuator, {Rating::kContinuous, {}, {}, {}}, 0.0);
  const double there_Nm =
      range.is_empty ? 0.0 : std::min(range.greatest.torque_Nm, -range.least.torque_Nm);
  return {there_Nm / wanted_Nm - 1.0,
          fmt::format("{:.4g} of {:.4g} Nm may last", there_Nm, wanted_Nm)};
}

bool states_what_lasts(const Actuator& actuator) {
  return objections(actuator, {Rating::kContinuous, {}, {}, {}}).empty();
}

/// Of the drive as it is.
Suitability as_it_is(const Actuator& actuator, const Wanted& wanted) {
  Suitability result;
  result.ratio = actuator.transmission.ratio;
  double least_share = kUnlimited;
  const auto take = [&](const Answer& one) {
    least_share = std::min(least_share, one.share);
    if (one.share < 0.0) result.reasons.push_back(one.reason);
  };
  for (const Need& need : wanted.needs) take(answer(actuator, need));
  bool is_known = true;
  if (wanted.continuous_Nm && states_what_lasts(actuator)) {
    take(continuous_answer(actuator, *wanted.continuous_Nm));
  } else if (wanted.continuous_Nm) {
    is_known = false;
    result.is_unknown = result.reasons.empty();
    result.reasons.push_back("states no torque or current that may last");
  }
  if (is_known || least_share < 0.0) result.margin_share = least_share;
  return result;
}

Suitability at_best_ratio(const Actuator& actuator, const Wanted& wanted) {
  Actuator changed = actuator;
  const double sign = std::copysign(1.0, actuator.transmission.ratio);
  std::optional<Suitability> best;
  const auto [least, greatest] = *wanted.ratios;
  const int steps = static_cast<int>(std::ceil(std::log(greatest / least) / std::log(kRatioStep)));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
    changed.transmission.ratio = sign * least * std::pow(greatest / least, share);
    Suitability one = as_it_is(changed, wanted);
    if (!best || one.margin_share > best->margin_share) best = std::move(one);
  }
  return *best;
}

}  // namespace

Suitability suitability(const Actuator& actuator, const Wanted& wanted) {
  Suitability result = wanted.ratios ? at_best_ratio(actuator, wanted) : as_it_is(actuator, wanted);
  if (wanted.mass_below_kg && !actuator.mass_kg) {
    result.is_unknown = result.is_unknown || result.reasons.empty();
    result.reasons.push_back("states no mass");
  } else if (wanted.mass_below_kg && !(*actuator.mass_kg < *wanted.mass_below_kg)) {
    result.is_unknown = false;
    result.reasons.push_back(fmt::format("weighs {:.4g} kg, not below {:.4g}", *actuator.mass_kg,
                                         *wanted.mass_below_kg));
  }
  result.fits = result.reasons.empty();
  return result;
}

}  // namespace torquewright::actuator
