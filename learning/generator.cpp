// SPDX-License-Identifier: Apache-2.0
#include "learning/generator.hpp"

#include <cmath>
#include <numbers>

namespace torquewright::learning {
namespace {

constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15;

std::uint64_t stirred(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

}  // namespace

// The seed is stirred before the number comes to it, and both again, so that streams begin far
// from one another: (1, 2) is not (2, 1), nor (1, 1) one step ahead of (1, 0).
Generator::Generator(std::uint64_t seed, std::uint64_t number)
    : state_(stirred(stirred(seed + kGoldenStep) + number)) {}

std::uint64_t Generator::bits() { return stirred(state_ += kGoldenStep); }

double Generator::uniform() { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53; }

// A remainder would prefer low numbers by count / 2^64, which no training will ever see.
std::uint64_t Generator::below(std::uint64_t count) { return bits() % count; }

double Generator::normal() {
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace torquewright::learning
