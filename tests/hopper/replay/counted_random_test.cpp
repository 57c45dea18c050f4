// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/counted_random.hpp"

#include <gtest/gtest.h>

#include "tests/hopper/replay/kolmogorov.hpp"

namespace torquewright::hopper {
namespace {

constexpr std::size_t kDraws = 20000;

double as_uniform(std::uint64_t bits) { return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53; }

// Oracle: the first outputs of SplitMix64 from the state 1234567 as published; its state goes on by
// 0x9e3779b97f4a7c15.
TEST(CountedRandom, IsSplitMix64) {
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;
  EXPECT_EQ(uniform_of(1234567), as_uniform(6457827717110365317u));
  EXPECT_EQ(uniform_of(1234567 + kStep), as_uniform(3203168211198807973u));
  EXPECT_EQ(uniform_of(1234567 + 2 * kStep), as_uniform(9817491932198370423u));
}

// Oracle: FNV-1a's published values of these names.
TEST(CountedRandom, HashesNamesTheSameEverywhere) {
  EXPECT_EQ(mixed_in(5, std::string_view("")), mixed_in(5, std::uint64_t{0xcbf29ce484222325}));
  EXPECT_EQ(mixed_in(5, "a"), mixed_in(5, std::uint64_t{0xaf63dc4c8601ec8c}));
  EXPECT_EQ(mixed_in(5, "foobar"), mixed_in(5, std::uint64_t{0x85944171f73967e8}));
}

// (1, 2), (2, 1) and (0, 3) are three things.
TEST(CountedRandom, TellsTheOrderOfWhatIsMixedIn) {
  const auto both = [](std::uint64_t a, std::uint64_t b) { return mixed_in(mixed_in(7, a), b); };
  EXPECT_NE(both(1, 2), both(2, 1));
  EXPECT_NE(both(1, 2), both(0, 3));
  EXPECT_NE(mixed_in(1, std::uint64_t{2}), mixed_in(2, std::uint64_t{1}));
}

// Oracle: the uniform distribution, of keys that count up.
TEST(CountedRandom, IsUniform) {
  std::vector<double> sample;
  for (std::uint64_t i = 0; i < kDraws; ++i) sample.push_back(uniform_of(mixed_in(3, i)));
  EXPECT_LT(test::distance_to([](double x) { return x; }, sample), test::distance_bound(kDraws));
}

// Oracle: the normal distribution by the library's error function.
TEST(CountedRandom, IsNormal) {
  std::vector<double> sample;
  for (std::uint64_t i = 0; i < kDraws; ++i) sample.push_back(normal_of(mixed_in(4, i)));
  const auto normal = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  EXPECT_LT(test::distance_to(normal, sample), test::distance_bound(kDraws));
}

}  // namespace
}  // namespace torquewright::hopper
