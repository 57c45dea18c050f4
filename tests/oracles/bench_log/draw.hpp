// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/bench_log/dial.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace torquewright::oracles {

/// Effect over noise floor, as drawn: evenly over the logarithm.
inline constexpr double kLeastMultiple = 2.0, kMostMultiple = 10.0;

/// Turns the dial until the effect alone adds `multiple` noise floors to its residual; where its
/// plausible strengths do not reach that, the noise of the channels is turned instead. Writes the
/// rms into the effect; returns the strength.
double tune(Bench& bench, Dial& dial, double multiple);

/// The bench with the truth as it stands in it, as log and documents.
Scenario make_scenario(const Bench& bench, Truth truth, std::uint64_t seed, Chance& chance);

/// Of kCannotTell and kOutside.
Scenario draw_poor(std::uint64_t seed);
Scenario draw_outside(std::uint64_t seed);

}  // namespace torquewright::oracles
