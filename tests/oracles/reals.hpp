// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>

namespace torquewright::oracles {

// Real numbers are long doubles here: eleven bits more than the doubles that are judged.

inline constexpr long double kPi = std::numbers::pi_v<long double>;

inline long double real(std::int64_t teeth) { return static_cast<long double>(teeth); }

}  // namespace torquewright::oracles
