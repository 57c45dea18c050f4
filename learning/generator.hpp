// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace torquewright::learning {

/// Random numbers of one purpose: the stream of that number under that seed (SplitMix64; Steele,
/// Lea and Flood 2014), the same with every library. All that it remembers is its state.
class Generator {
 public:
  Generator(std::uint64_t seed, std::uint64_t number);

  std::uint64_t state() const { return state_; }
  void set_state(std::uint64_t state) { state_ = state; }

  std::uint64_t bits();
  /// Uniform, above 0 and below 1.
  double uniform();
  /// Uniform in 0 ... count - 1. Requires a count above 0.
  std::uint64_t below(std::uint64_t count);
  /// Normal, of mean 0 and deviation 1 (Box and Muller).
  double normal();

 private:
  std::uint64_t state_;
};

}  // namespace torquewright::learning
