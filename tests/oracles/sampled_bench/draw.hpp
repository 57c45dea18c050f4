// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace torquewright::oracles::sampled {

/// Draws that are the same with every standard library: only the engine is the standard's.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed * 0x9e3779b97f4a7c15ULL + 0x2545f491ULL) {}

  std::uint64_t bits() { return engine_(); }
  double uniform(double least = 0.0, double most = 1.0) {
    return least + (most - least) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  double log_uniform(double least, double most) {
    return std::exp(uniform(std::log(least), std::log(most)));
  }
  bool chance(double share) { return uniform() < share; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  int between(int least, int most) {  // both included
    return least + static_cast<int>(uniform() * (most - least + 1));
  }
  double normal() {  // Box and Muller
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  template <typename T>
  const T& one_of(const std::vector<T>& choices) {
    return choices[static_cast<std::size_t>(between(0, static_cast<int>(choices.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace torquewright::oracles::sampled
