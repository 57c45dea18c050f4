// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/wave_share.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

/// Of a wave's rms: below it nine tenths of its power rest on what the band's filter and the other
/// members are said to take, which no law knows that exactly. Waves that were there showed 0.9 to
/// 1.1 in logs of another generator, two that were not 0.03 and 0.17.
constexpr double kLeastSeen = 0.3;
/// Standard errors: an amplitude within them could be none in one run of twenty.
constexpr double kLeastErrors = 2.0;

double rms_of_rows(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() /
                   static_cast<double>(std::max<Eigen::Index>(1, values.size())));
}

bool is_known(const FoundWave& wave) {
  return wave.amplitude.value > kLeastErrors * wave.amplitude.standard_error;
}

double rms_of_waves(const FoundParameters& parameters) {
  double squares = 0.0;
  for (const FoundWave& each : parameters.waves) squares += 0.5 * std::pow(each.amplitude.value, 2);
  return std::sqrt(squares);
}

}  // namespace

void doubt_waves_hardly_seen(const ModelFitter& fitter, const ModelFit& fit,
                             EquationResult& result) {
  for (NamedEffect& each : result.added) {
    const std::vector<FoundWave>& waves = each.parameters.waves;
    if (waves.empty() || !each.doubt.empty()) continue;
    if (std::none_of(waves.begin(), waves.end(), is_known)) {
      each.doubt = fmt::format(
          "of no wave is the amplitude larger than {:g} of its standard errors: parts of the log "
          "disagree on it",
          kLeastErrors);
      continue;
    }
    const double all = rms_of_waves(each.parameters);
    if (all == 0.0 || each.parameters.proportional.value_or(false)) continue;
    const PartOfModel others = part_of(fit, [&](const EffectCandidate& member) {
      return member.effect != each.effect || member.order == 0.0;
    });
    const ModelFit without = fitter.fit(others.members, others.coordinates);
    const double seen = rms_of_rows(without.residual - fit.residual);
    if (seen >= kLeastSeen * all) continue;
    each.doubt = fmt::format(
        "of its waves' {:.3g} Nm rms the log shows {:.3g}: they pass too fast for the band, or "
        "what else is fitted takes the rest; a slower turn would tell",
        all, seen);
  }
}

}  // namespace torquewright::identification
