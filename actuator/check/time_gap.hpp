// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "actuator/drive_check/report.hpp"

namespace torquewright::actuator {

/// A step longer than so many others is reported, because integrals and slopes cross it linearly. A
/// choice of ours.
constexpr double kGap = 20.0;

/// In a longer step than this a leg may have made a stance that nobody has seen. A choice of ours.
constexpr double kMostUnseen_s = 0.1;

std::optional<Finding> gap_finding(const LongestStep& step);

/// Whether a step is longer than both limits, so that slopes across it are no motion's.
bool hides_motion(const LongestStep& step);

/// Returns a sentence that says why rates, such as "accelerations", cannot be derived across the
/// step, and what can be done. --from and --until are in the file's own clock.
std::string hidden_motion_sentence(const LongestStep& step, double clock_origin_s,
                                   std::string_view rates);

}  // namespace torquewright::actuator
