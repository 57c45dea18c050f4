// SPDX-License-Identifier: Apache-2.0
#include "identification/channel_noise.hpp"

#include <algorithm>
#include <cmath>

#include "identification/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastSamples = 16;

/// Step of a quantised channel; 0 of one that is not.
double quantum(const std::vector<double>& signal) {
  double least = 0.0;
  std::size_t equal = 0;
  for (std::size_t i = 1; i < signal.size(); ++i) {
    const double step = std::abs(signal[i] - signal[i - 1]);
    if (step == 0.0) ++equal;
    if (step > 0.0 && (least == 0.0 || step < least)) least = step;
  }
  // White noise never repeats a value; a quantised channel does.
  return 20 * equal > signal.size() ? least : 0.0;
}

/// Of all runs, by their lengths.
struct Mean {
  double sum = 0.0, weight = 0.0;

  void add(const std::vector<double>& signal) {
    if (signal.size() < kLeastSamples) return;
    const double level = std::max(noise_level(signal), quantum(signal) / std::sqrt(12.0));
    sum += level * level * static_cast<double>(signal.size());
    weight += static_cast<double>(signal.size());
  }
  double level() const { return weight > 0.0 ? std::sqrt(sum / weight) : 0.0; }
};

}  // namespace

NoiseLevels noise_levels(const Log& log, std::size_t joint) {
  std::array<Mean, kQuantityCount> means;
  for (const Run& run : log.runs) {
    for (std::size_t q = 0; q < kQuantityCount; ++q) means[q].add(run.joints[joint].of[q]);
  }
  NoiseLevels levels{};
  for (std::size_t q = 0; q < kQuantityCount; ++q) {
    const auto quantity = static_cast<Quantity>(q);
    if (quantity == Quantity::kTime || quantity == Quantity::kRun) continue;
    levels[q] = means[q].level();
  }
  return levels;
}

}  // namespace torquewright::identification
