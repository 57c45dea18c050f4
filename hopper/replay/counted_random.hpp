// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace torquewright::hopper {

/// Random numbers without a state: each is a function of what it is for. The key of a draw is built
/// up from seed, number of the trial, and names; adding one more thing to draw moves no other. The
/// mixing is SplitMix64's (Steele, Lea and Flood 2014), a bijection of 64 bits of which one changed
/// bit changes half.
std::uint64_t mixed_in(std::uint64_t key, std::uint64_t value);
/// A key made of another and of a name's bytes (FNV-1a), whatever the library's own hash is.
std::uint64_t mixed_in(std::uint64_t key, std::string_view name);

/// Above 0 and below 1: odd multiples of 2^-54, the same with every library.
double uniform_of(std::uint64_t key);

/// A normal number of mean 0 and deviation 1 for that key, by Box and Muller: a library's own
/// normal distribution differs from another's. No greater than 8.7 in size.
double normal_of(std::uint64_t key);

}  // namespace torquewright::hopper
