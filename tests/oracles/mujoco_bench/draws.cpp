// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/draws.hpp"

#include <cmath>
#include <numbers>

namespace torquewright::oracles::mujoco_bench {

std::uint64_t Draws::next() {
  state_ += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

double Draws::uniform(double low, double high) {
  const double share = static_cast<double>(next() >> 11) * 0x1.0p-53;
  return low + (high - low) * share;
}

double Draws::log_uniform(double low, double high) {
  return std::exp(uniform(std::log(low), std::log(high)));
}

double Draws::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform(0, 1)));
  return radius * std::cos(2 * std::numbers::pi * uniform(0, 1));
}

std::size_t Draws::below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

bool Draws::chance(double probability) { return uniform(0, 1) < probability; }

double Draws::sign() { return chance(0.5) ? 1 : -1; }

}  // namespace torquewright::oracles::mujoco_bench
