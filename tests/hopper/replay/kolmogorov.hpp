// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace torquewright::hopper::test {

/// That a right distribution fails one test; seeds are fixed, so that none does by chance anew.
constexpr double kErrorProbability = 1e-6;

/// Largest distance between the distribution of a sample and the one that it should have
/// (Kolmogorov and Smirnov).
template <typename Distribution>
double distance_to(const Distribution& distribution, std::vector<double> sample) {
  std::sort(sample.begin(), sample.end());
  const auto size = static_cast<double>(sample.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double share = distribution(sample[i]);
    const auto below = static_cast<double>(i);
    distance = std::max({distance, share - below / size, (below + 1.0) / size - share});
  }
  return distance;
}

/// Which no sample of the right distribution exceeds but with kErrorProbability: P(D > d) <=
/// 2 exp(-2 n d^2) (Dvoretzky, Kiefer, Wolfowitz; Massart's constant).
inline double distance_bound(std::size_t size) {
  return std::sqrt(std::log(2.0 / kErrorProbability) / (2.0 * static_cast<double>(size)));
}

/// The same of the mean of independent numbers in a range of this width (Hoeffding).
inline double mean_bound(std::size_t size, double width) { return width * distance_bound(size); }

}  // namespace torquewright::hopper::test
