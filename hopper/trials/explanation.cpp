// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::hopper {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMostBins = 16.0;

/// Missing rotations of the trials that landed, with whether each succeeded.
struct Landed {
  double short_rad = 0.0;
  bool has_succeeded = false;
};

std::vector<Landed> landed_of(const TrialOutcomes& outcomes) {
  std::vector<Landed> landed;
  for (const std::optional<TrialOutcome>& one : outcomes) {
    if (!one || !one->rotation_short_rad) continue;
    landed.push_back({*one->rotation_short_rad, one->verdict == ReplayVerdict::kStands});
  }
  return landed;
}

/// The narrowest usual width of which few enough bins cover a span.
double width_deg(double span_deg) {
  for (double decade = 1.0;; decade *= 10.0) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (span_deg <= (kMostBins - 1.0) * digit * decade) return digit * decade;
    }
  }
}

}  // namespace

std::optional<RotationSpread> rotation_spread(const TrialOutcomes& outcomes) {
  const std::vector<Landed> landed = landed_of(outcomes);
  if (landed.size() < 2) return std::nullopt;
  RotationSpread spread;
  spread.landed = landed.size();
  const auto count = static_cast<double>(landed.size());
  for (const Landed& one : landed) spread.mean_rad += one.short_rad / count;
  double squares = 0.0;
  for (const Landed& one : landed) squares += std::pow(one.short_rad - spread.mean_rad, 2);
  spread.deviation_rad = std::sqrt(squares / (count - 1.0));
  return spread;
}

CauseEffect effect_of_cause(const std::string& cause, const TrialOutcomes& alone,
                            const TrialOutcomes& all) {
  CauseEffect effect{cause, counted(alone), rotation_spread(alone), std::nullopt};
  const auto together = rotation_spread(all);
  if (effect.rotation && together && together->deviation_rad > 0.0) {
    effect.variance_share = std::pow(effect.rotation->deviation_rad / together->deviation_rad, 2);
  }
  return effect;
}

std::vector<RotationBin> rotation_bins(const TrialOutcomes& outcomes) {
  const std::vector<Landed> landed = landed_of(outcomes);
  if (landed.empty()) return {};
  const auto [least, most] = std::minmax_element(
      landed.begin(), landed.end(),
      [](const Landed& a, const Landed& b) { return a.short_rad < b.short_rad; });
  const double width = width_deg(kDegrees * (most->short_rad - least->short_rad));
  const double first = std::floor(kDegrees * least->short_rad / width);
  const double last = std::floor(kDegrees * most->short_rad / width);
  std::vector<RotationBin> bins;
  for (double bin = first; bin <= last; ++bin) bins.push_back({bin * width, (bin + 1.0) * width});
  for (const Landed& one : landed) {
    const double bin = std::floor(kDegrees * one.short_rad / width) - first;
    RotationBin& in = bins[static_cast<std::size_t>(bin)];
    ++(one.has_succeeded ? in.succeeded : in.failed);
  }
  return bins;
}

}  // namespace torquewright::hopper
