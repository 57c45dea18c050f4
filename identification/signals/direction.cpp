// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/direction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr double kWithinNoise = 3.0;          ///< Deviations within which a sign is not known.
constexpr double kBeyondNoise = 4.0;          ///< The same of wide bands: they are asked oftener.
constexpr double kNear = 1.0;                 ///< Periods of a band's cut-off.
constexpr double kBands[] = {2.0, 4.0, 8.0};  ///< Times the low-pass's own.
constexpr double kHighest = 0.45;             ///< Of the sampling rate.

/// Deviation that white noise on a position leaves in the derivative below a cut-off.
double velocity_noise(double deviation_rad, double cutoff_Hz, double step_s) {
  const double share = std::min(1.0, 2.0 * cutoff_Hz * step_s);
  return deviation_rad * 2.0 * std::numbers::pi * cutoff_Hz * std::sqrt(share / 3.0);
}

/// Puts a wider band's velocity where it is beyond its noise, and where it turns between two such
/// samples that are so near that a narrower band would move the reversal further than noise does.
void widen(double cutoff_Hz, const std::vector<double>& unfiltered_rad,
           const PositionSamples& samples, std::vector<double>& velocity_rad_s) {
  const std::vector<double> wide = velocity_below(cutoff_Hz, unfiltered_rad, samples.step_s);
  const double known =
      kBeyondNoise * velocity_noise(samples.deviation_rad, cutoff_Hz, samples.step_s);
  const auto near = static_cast<std::size_t>(kNear / (cutoff_Hz * samples.step_s));
  std::size_t last = wide.size();
  for (std::size_t i = 0; i < wide.size(); ++i) {
    if (std::abs(wide[i]) <= known) continue;
    const bool turns = last < i && i - last <= near && wide[i] * wide[last] < 0.0;
    for (std::size_t k = turns ? last + 1 : i; k <= i; ++k) velocity_rad_s[k] = wide[k];
    last = i;
  }
}

/// Integral of clamp(x, -1, 1).
double integral(double x) { return std::abs(x) < 1.0 ? 0.5 * x * x : std::abs(x) - 0.5; }

/// Mean of clamp(x, -1, 1) where x goes from one value to the other at an even rate.
double mean_sign(double from, double to) {
  if (std::abs(to - from) < 1e-9 * (1.0 + std::abs(from))) return std::clamp(from, -1.0, 1.0);
  return std::clamp((integral(to) - integral(from)) / (to - from), -1.0, 1.0);
}

}  // namespace

std::vector<double> velocity_below(double cutoff_Hz, const std::vector<double>& unfiltered_rad,
                                   double step_s) {
  std::vector<double> low = unfiltered_rad;
  LowPass(cutoff_Hz, 1.0 / step_s).apply(low);
  return derivative(low, step_s);
}

std::vector<double> directions(const std::vector<double>& velocity_rad_s,
                               const std::vector<double>& unfiltered_rad,
                               const PositionSamples& samples) {
  std::vector<double> velocity = velocity_rad_s;
  if (!unfiltered_rad.empty()) {
    for (const double band : kBands) {
      const double cutoff_Hz = band * samples.cutoff_Hz;
      if (cutoff_Hz < kHighest / samples.step_s) {
        widen(cutoff_Hz, unfiltered_rad, samples, velocity);
      }
    }
  }
  const double noise =
      kWithinNoise * velocity_noise(samples.deviation_rad, samples.cutoff_Hz, samples.step_s);
  // Far below any speed that is measured: a sign, and 0 at rest.
  const double unit = std::max(noise, 1e-12);
  const std::size_t n = velocity.size();
  std::vector<double> direction(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double own = velocity[i] / unit;
    const double before = i > 0 ? 0.5 * (velocity[i - 1] / unit + own) : own;
    const double after = i + 1 < n ? 0.5 * (velocity[i + 1] / unit + own) : own;
    direction[i] = 0.5 * (mean_sign(before, own) + mean_sign(own, after));
  }
  return direction;
}

}  // namespace torquewright::identification
