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
/// Makes a key from another key and a name's bytes (FNV-1a), independent of the library's own hash.
std::uint64_t mixed_in(std::uint64_t key, std::string_view name);

/// Returns a uniform number above 0 and below 1: odd multiples of 2^-54, the same with every
/// library.
double uniform_of(std::uint64_t key);

/// Returns a normal number of mean 0 and deviation 1 for that key, by Box and Muller, because
/// libraries' own normal distributions differ. No greater than 8.7 in size.
double normal_of(std::uint64_t key);

}  // namespace torquewright::hopper
