// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/direction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "identification/signals/signal.hpp"
#include "identification/signals/signs.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr double kNarrower[] = {1.0, 0.5, 0.25, 0.125};  ///< Times the low-pass's own cut-off.
constexpr double kOfFastest = 0.25;  ///< Of the highest speeds, that is to stand out of the noise.

double fastest_of(std::vector<double> speeds_rad_s) {
  for (double& each : speeds_rad_s) each = std::abs(each);
  return optimization::lower_quantile(std::move(speeds_rad_s), 0.95);
}

}  // namespace

std::vector<double> RawMotion::speed_below(double cutoff_Hz) const {
  std::vector<double> low = values;
  LowPass(cutoff_Hz, 1.0 / step_s).apply(low);
  return is_speed ? low : derivative(low, step_s);
}

/// White noise on a position leaves 2 pi times cut-off over sqrt(3) of itself in the derivative.
double RawMotion::speed_noise(double cutoff_Hz) const {
  const double below = deviation * std::sqrt(std::min(1.0, 2.0 * cutoff_Hz * step_s));
  return is_speed ? below : below * 2.0 * std::numbers::pi * cutoff_Hz / std::numbers::sqrt3;
}

double RawMotion::seen_below_Hz(double cutoff_Hz) const {
  if (values.empty()) return cutoff_Hz;
  for (const double times : kNarrower) {
    const double known_rad_s = kBeyondNoise * speed_noise(times * cutoff_Hz);
    if (known_rad_s < kOfFastest * fastest_of(speed_below(times * cutoff_Hz)))
      return times * cutoff_Hz;
  }
  return cutoff_Hz;
}

std::vector<double> directions(const std::vector<double>& speed_rad_s, const RawMotion& raw,
                               double cutoff_Hz) {
  Bands bands;
  if (!raw.values.empty()) {
    bands.below = [&](double below_Hz) { return raw.speed_below(below_Hz); };
  }
  bands.noise = [&](double below_Hz) { return raw.speed_noise(below_Hz); };
  bands.cutoff_Hz = cutoff_Hz;
  bands.step_s = raw.step_s;
  return mean_signs(speed_rad_s, bands);
}

}  // namespace torquewright::identification
