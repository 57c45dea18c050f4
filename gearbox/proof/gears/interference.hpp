// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace torquewright::gearbox::proof {

/// The ring's tip does not reach inside the planet's base circle: P/R - 1 + tan a2 / tan a >= 0.
bool is_free_of_involute_interference(std::int64_t planet, std::int64_t ring);

/// theta_1 P/R + inv a - inv a2 - theta_2 >= 0. Requires ring >= planet + 2: then the tip circles
/// meet.
bool is_free_of_trochoid_interference(std::int64_t planet, std::int64_t ring);

}  // namespace torquewright::gearbox::proof
