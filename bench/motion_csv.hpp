// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/flip_motion.hpp"

namespace torquewright::bench {

/// Prints samples in the plane of x and z as a motion of the hopper with a spatial base, for
/// `hopper check`; the lines of `comment` begin it.
void print_motion(const char* comment, const std::vector<FlipSample>& samples);

}  // namespace torquewright::bench
