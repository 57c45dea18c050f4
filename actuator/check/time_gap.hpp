// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "actuator/check/report.hpp"

namespace torquewright::actuator {

/// A step of more than this many others' length is said: integrals and slopes run straight across.
constexpr double kGap = 20.0;

/// Nobody knows what a leg did in a longer step: it can have made a stance of its own.
constexpr double kMostUnseen_s = 0.1;

std::optional<Finding> gap_finding(const LongestStep& step);

/// Longer than both, so that slopes across it are no motion's.
bool hides_motion(const LongestStep& step);

/// Why rates, such as "accelerations", cannot be had across it, and what can be done.
/// --from and --until are in the file's own clock.
std::string hidden_motion_sentence(const LongestStep& step, double clock_origin_s,
                                   std::string_view rates);

}  // namespace torquewright::actuator
