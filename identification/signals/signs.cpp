// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/signs.hpp"

#include <algorithm>
#include <cmath>

#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

/// Of white noise on x the expected sign is erf(x/(sqrt 2 deviation)); a ramp of the same slope.
constexpr double kUnsure = 1.2533141373155003;  // sqrt(pi/2)
constexpr double kNear = 1.0;                   ///< Periods of a band's cut-off.
constexpr double kWider[] = {2.0, 4.0, 8.0};    ///< Times the low-pass's own.
constexpr double kHighest = 0.45;               ///< Of the sampling rate.

/// Puts a wider band where it is beyond its noise, and where it turns between two such samples that
/// are so near that a narrower band would move the reversal further than noise does.
void widen(double cutoff_Hz, const Bands& bands, std::vector<double>& values) {
  const std::vector<double> wide = bands.below(cutoff_Hz);
  const double known = kBeyondNoise * bands.noise(cutoff_Hz);
  const auto near = static_cast<std::size_t>(kNear / (cutoff_Hz * bands.step_s));
  std::size_t last = wide.size();
  for (std::size_t i = 0; i < wide.size(); ++i) {
    if (std::abs(wide[i]) <= known) continue;
    const bool turns = last < i && i - last <= near && wide[i] * wide[last] < 0.0;
    for (std::size_t k = turns ? last + 1 : i; k <= i; ++k) values[k] = wide[k];
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

std::vector<double> low_passed(std::vector<double> values, double cutoff_Hz, double step_s) {
  LowPass(cutoff_Hz, 1.0 / step_s).apply(values);
  return values;
}

}  // namespace

std::vector<double> mean_signs(std::vector<double> values, const Bands& bands) {
  for (const double times : kWider) {
    const double cutoff_Hz = times * bands.cutoff_Hz;
    if (!bands.below || cutoff_Hz >= kHighest / bands.step_s) break;
    widen(cutoff_Hz, bands, values);
  }
  // Far below anything that is measured: a sign, and 0 where there is nothing.
  const double unit = std::max(bands.unsure_deviations * bands.noise(bands.cutoff_Hz), 1e-12);
  const std::size_t n = values.size();
  std::vector<double> sign(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double own = values[i] / unit;
    const double before = i > 0 ? 0.5 * (values[i - 1] / unit + own) : own;
    const double after = i + 1 < n ? 0.5 * (values[i + 1] / unit + own) : own;
    sign[i] = 0.5 * (mean_sign(before, own) + mean_sign(own, after));
  }
  return sign;
}

std::vector<double> mean_signs_of(const std::vector<double>& unfiltered, double deviation,
                                  double cutoff_Hz, double step_s) {
  Bands bands;
  bands.below = [&](double below_Hz) { return low_passed(unfiltered, below_Hz, step_s); };
  bands.noise = [&](double below_Hz) {
    return deviation * std::sqrt(std::min(1.0, 2.0 * below_Hz * step_s));
  };
  bands.cutoff_Hz = cutoff_Hz;
  bands.step_s = step_s;
  bands.unsure_deviations = kUnsure;
  return mean_signs(bands.below(cutoff_Hz), bands);
}

}  // namespace torquewright::identification
