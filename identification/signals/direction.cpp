// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/direction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/signals/signal.hpp"
#include "identification/signals/signs.hpp"

namespace torquewright::identification {
namespace {

/// Deviation that white noise on a position leaves in the derivative below a cut-off.
double velocity_noise(double deviation_rad, double cutoff_Hz, double step_s) {
  const double share = std::min(1.0, 2.0 * cutoff_Hz * step_s);
  return deviation_rad * 2.0 * std::numbers::pi * cutoff_Hz * std::sqrt(share / 3.0);
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
  Bands bands;
  if (!unfiltered_rad.empty()) {
    bands.below = [&](double cutoff_Hz) {
      return velocity_below(cutoff_Hz, unfiltered_rad, samples.step_s);
    };
  }
  bands.noise = [&](double cutoff_Hz) {
    return velocity_noise(samples.deviation_rad, cutoff_Hz, samples.step_s);
  };
  bands.cutoff_Hz = samples.cutoff_Hz;
  bands.step_s = samples.step_s;
  return mean_signs(velocity_rad_s, bands);
}

}  // namespace torquewright::identification
