// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/flip_motion.hpp"

namespace torquewright::bench {

/// Changes the time of flight and the knee's angle at touch-down so that the sole meets the ground
/// flat, turned by numbers.turn_rad: Newton's method from near.
void close_flight(FlipMaker& maker, const std::vector<int>& steps, FlipNumbers& numbers);

}  // namespace torquewright::bench
