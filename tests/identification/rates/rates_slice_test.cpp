// SPDX-License-Identifier: Apache-2.0
// A fast slice of the measured rates (bench/identification_rates): logs of every class with seeds
// from 1000 on, which no threshold was chosen by.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/identification/rates/trial.hpp"
#include "tests/long_run.hpp"

namespace torquewright::rates {
namespace {

using oracles::LogClass;

constexpr std::uint64_t kFirstSeed = 1000;

struct Count {
  int not_right = 0;  ///< First name not the truth's.
  int wrong = 0;      ///< A name that stands alone and is not there.
  int not_all = 0;    ///< Not everything found.
  int named = 0;
  std::string lines;
};

/// Of logs of a class: the first half of them, unless long studies run.
std::uint64_t logs(std::uint64_t all) { return test::is_long_run() ? all : all / 2; }

/// Oracle: the truth that the simulation of the log put in, by a code of its own.
Count count(LogClass log_class, std::uint64_t first, std::uint64_t many) {
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      fmt::format("rates_slice_{}_{}", oracles::name_of(log_class), first);
  Count count;
  for (std::uint64_t seed = first; seed < first + many; ++seed) {
    const Outcome outcome = try_out(oracles::draw(log_class, seed), folder);
    count.not_right += !outcome.first_is_right;
    count.wrong += outcome.any_wrong;
    count.not_all += !outcome.all_found;
    count.named += !outcome.names.empty();
    count.lines += fmt::format("{} {}:", seed, outcome.truth);
    for (const std::string& name : outcome.names) count.lines += " " + name;
    count.lines += "\n";
  }
  std::filesystem::remove_all(folder);
  return count;
}

TEST(RatesSlice, NamesNothingWhereNothingIsMissing) {
  const Count counted = count(LogClass::kNone, kFirstSeed, logs(6));
  EXPECT_EQ(counted.named, 0) << counted.lines;
}

// Four cases, so that they run side by side. At the goal of 98 % right, two of four logs go wrong
// once in 400 such cases (binomial); one is allowed.
class OneEffect : public testing::TestWithParam<int> {};
TEST_P(OneEffect, IsNamedAndNothingElseIs) {
  const Count counted =
      count(LogClass::kOne, kFirstSeed + 4 * static_cast<std::uint64_t>(GetParam()), 4);
  EXPECT_LE(counted.not_right, 1) << counted.lines;
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
}
INSTANTIATE_TEST_SUITE_P(RatesSlice, OneEffect, testing::Range(0, 4));

TEST(RatesSlice, NamesTwoEffectsAndNothingElse) {
  const Count counted = count(LogClass::kTwo, kFirstSeed, logs(6));
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
  EXPECT_EQ(counted.not_all, 0) << counted.lines;
}

// The goal of 2 % allows none in most draws.
TEST(RatesSlice, NamesNoEffectForWhatIsOutsideTheLibrary) {
  const Count counted = count(LogClass::kOutside, kFirstSeed, logs(4));
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
}

// Logs that laws of the library resemble: a dead zone, friction that grows with time, spots of
// friction.
class LooksLikeAnEffect : public testing::TestWithParam<std::uint64_t> {};
TEST_P(LooksLikeAnEffect, IsNotNamed) {
  const Count counted = count(LogClass::kOutside, GetParam(), 1);
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
}
INSTANTIATE_TEST_SUITE_P(RatesSlice, LooksLikeAnEffect, testing::Values(2, 8, 33, 57));

// What one effect leaves when its curve is not quite met resembles a second one: of saturation an
// error of the torque constant, of a gap a delay.
TEST(RatesSlice, SaturationIsNotAlsoAnErrorOfTheConstant) {
  const Count counted = count(LogClass::kTwo, 61, 1);
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
  EXPECT_EQ(counted.not_all, 0) << counted.lines;
}
TEST(RatesSlice, AGapIsNoDelay) {
  const Count counted = count(LogClass::kOne, 97, 1);
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
  EXPECT_EQ(counted.not_right, 0) << counted.lines;
}

TEST(RatesSlice, CallsNothingCertainThatTheLogCannotTell) {
  const Count counted = count(LogClass::kCannotTell, kFirstSeed, logs(4));
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
}

// At the goal of 80 % found, two of four are missed once in five such draws; one is allowed.
TEST(RatesSlice, FindsMostInShortLogs) {
  const Count counted = count(LogClass::kShort, kFirstSeed, 4);
  EXPECT_LE(counted.not_all, 1) << counted.lines;
  EXPECT_EQ(counted.wrong, 0) << counted.lines;
}

}  // namespace
}  // namespace torquewright::rates
