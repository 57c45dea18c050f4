// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/counted_random.hpp"

#include <cmath>

namespace torquewright::hopper {
namespace {

constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15;
constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325;
constexpr std::uint64_t kFnvPrime = 0x100000001b3;

std::uint64_t scrambled(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

}  // namespace

std::uint64_t mixed_in(std::uint64_t key, std::uint64_t value) {
  // The key is scrambled before the value comes to it: without, (1, 2) and (2, 1) would be one.
  return scrambled(scrambled(key + kGoldenStep) + value);
}

std::uint64_t mixed_in(std::uint64_t key, std::string_view name) {
  std::uint64_t hash = kFnvStart;
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * kFnvPrime;
  return mixed_in(key, hash);
}

double uniform_of(std::uint64_t key) {
  return (static_cast<double>(scrambled(key + kGoldenStep) >> 11) + 0.5) * 0x1p-53;
}

double normal_of(std::uint64_t key) {
  const double radius = std::sqrt(-2.0 * std::log(uniform_of(mixed_in(key, std::uint64_t{0}))));
  return radius * std::cos(2.0 * M_PI * uniform_of(mixed_in(key, std::uint64_t{1})));
}

}  // namespace torquewright::hopper
