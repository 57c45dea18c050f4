// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace torquewright::oracles::loop {

/// Draws that are the same everywhere.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {
    for (int skipped = 0; skipped < 4; ++skipped) (void)engine_();
  }
  double uniform(double least, double most) {
    constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
    return least + (most - least) * static_cast<double>(engine_() >> 11U) * kUnit;
  }
  double log_uniform(double least, double most) {
    return std::exp(uniform(std::log(least), std::log(most)));
  }
  bool chance(double share) { return uniform(0.0, 1.0) < share; }
  template <typename T>
  const T& one_of(const std::vector<T>& choices) {
    return choices[static_cast<std::size_t>(engine_() % choices.size())];
  }
  /// Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return radius * std::cos(uniform(0.0, 2.0 * std::numbers::pi));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace torquewright::oracles::loop
