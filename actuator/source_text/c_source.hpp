// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace torquewright::actuator {

/// C99 (and C++) that is the same for every actuator: a region as data and the clip to it. Guarded,
/// so that headers of several actuators go together.
extern const std::string_view kCSource;

}  // namespace torquewright::actuator
