// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator {

/// Returns the sum of A sin(order angle + phase).
double harmonic_sum(std::span<const Harmonic> harmonics, double angle_rad);

/// The sum's largest and smallest value over all angles. Where the orders are not all integers the
/// sum of amplitudes, which it comes arbitrarily close to or stays below.
struct HarmonicRange {
  double smallest;
  double largest;
};
HarmonicRange harmonic_range(std::span<const Harmonic> harmonics);

}  // namespace torquewright::actuator
