// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace torquewright::oracles {

/// Draws that are the same on every machine: a counter behind a mixing function (splitmix64), and
/// normal numbers by Box and Muller's formula.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : counter_(seed * 0x9E3779B97F4A7C15ULL + 0x1234567ULL) {}

  std::uint64_t bits() {
    counter_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t mixed = counter_;
    mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBULL;
    return mixed ^ (mixed >> 31U);
  }
  /// In [0, 1).
  double share() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
  double between(double least, double most) { return least + (most - least) * share(); }
  /// Evenly spread over the logarithm.
  double scale(double least, double most) { return least * std::pow(most / least, share()); }
  bool happens(double probability) { return share() < probability; }
  double sign() { return happens(0.5) ? 1.0 : -1.0; }
  double phase() { return between(0.0, 2.0 * std::numbers::pi); }
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
  template <typename List>
  const auto& one_of(const List& list) {
    return list[index(list.size())];
  }
  /// Mean 0, standard deviation 1.
  double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - share()));
    const double angle = phase();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }

 private:
  std::uint64_t counter_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace torquewright::oracles
