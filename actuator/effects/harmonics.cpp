// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/harmonics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::actuator {
namespace {

constexpr int kSamplesPerWave = 64;  // a sampled peak is less than h^2/8 of the curvature too low

double sum_of_amplitudes(std::span<const Harmonic> harmonics) {
  double sum = 0.0;
  for (const Harmonic& harmonic : harmonics) sum += std::abs(harmonic.amplitude);
  return sum;
}

/// Bound on the absolute second derivative by angle.
double curvature(std::span<const Harmonic> harmonics) {
  double sum = 0.0;
  for (const Harmonic& wave : harmonics) sum += std::abs(wave.amplitude) * wave.order * wave.order;
  return sum;
}

}  // namespace

double harmonic_sum(std::span<const Harmonic> harmonics, double angle_rad) {
  double sum = 0.0;
  for (const Harmonic& wave : harmonics) {
    sum += wave.amplitude * std::sin(wave.order * angle_rad + wave.phase_rad);
  }
  return sum;
}

HarmonicRange harmonic_range(std::span<const Harmonic> harmonics) {
  const double bound = sum_of_amplitudes(harmonics);
  if (harmonics.size() <= 1) return {-bound, bound};
  double greatest_order = 1.0;
  for (const Harmonic& wave : harmonics) {
    if (wave.order != std::round(wave.order)) return {-bound, bound};
    greatest_order = std::max(greatest_order, std::abs(wave.order));
  }
  const int samples = kSamplesPerWave * static_cast<int>(std::min(greatest_order, 4096.0));
  const double step_rad = 2.0 * std::numbers::pi / samples;
  HarmonicRange range{bound, -bound};
  for (int i = 0; i < samples; ++i) {
    const double value = harmonic_sum(harmonics, i * step_rad);
    range.smallest = std::min(range.smallest, value);
    range.largest = std::max(range.largest, value);
  }
  // A true extreme lies at most half a step from a sample, where the slope is zero: add the most
  // that the curvature allows, so that the worst angle is never made better than it is.
  const double allowance = curvature(harmonics) * step_rad * step_rad / 8.0;
  return {std::max(range.smallest - allowance, -bound), std::min(range.largest + allowance, bound)};
}

}  // namespace torquewright::actuator
