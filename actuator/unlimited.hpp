// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace torquewright::actuator {

/// The value of a limit that does not exist.
inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

}  // namespace torquewright::actuator
