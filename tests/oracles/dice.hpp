// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace torquewright::oracles {

/// Draws that are the same everywhere: the standard's distributions differ between libraries, its
/// engine does not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// A whole number from least to most, both included.
  std::int64_t between(std::int64_t least, std::int64_t most) {
    const auto span = static_cast<std::uint64_t>(most - least + 1);
    return least + static_cast<std::int64_t>(engine_() % span);
  }
  bool chance(std::int64_t percent) { return between(1, 100) <= percent; }
  template <typename T>
  const T& one_of(const std::vector<T>& choices) {
    return choices[static_cast<std::size_t>(
        between(0, static_cast<std::int64_t>(choices.size()) - 1))];
  }
  /// One value, or now and then two or three different ones in ascending order.
  template <typename T>
  std::vector<T> one_or_more_of(const std::vector<T>& choices) {
    std::vector<T> drawn{one_of(choices)};
    if (chance(30)) {
      for (std::int64_t more = between(1, 2); more > 0; --more) drawn.push_back(one_of(choices));
    }
    std::sort(drawn.begin(), drawn.end());
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
    return drawn;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace torquewright::oracles
