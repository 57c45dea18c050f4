// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace torquewright::oracles::mujoco_bench {

/// Random numbers that are the same with every library: SplitMix64 (Steele, Lea, Flood 2014).
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}

  double uniform(double low, double high);
  /// Uniform in the logarithm; both ends positive.
  double log_uniform(double low, double high);
  /// Standard normal (Box and Muller).
  double normal();
  /// 0 to count - 1.
  std::size_t below(std::size_t count);
  bool chance(double probability);
  /// -1 or 1.
  double sign();
  template <class T>
  const T& one_of(const std::vector<T>& choices) {
    return choices[below(choices.size())];
  }
  std::uint64_t next();

 private:
  std::uint64_t state_;
};

}  // namespace torquewright::oracles::mujoco_bench
