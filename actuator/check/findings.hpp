// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/check/report.hpp"
#include "actuator/check/time_gap.hpp"
#include "actuator/check/travel_agreement.hpp"
#include "actuator/check/velocity_agreement.hpp"

namespace torquewright::actuator {

/// What the reports give cause to say, a sentence each, violations first. docs/checks.md lists the
/// rules.
std::vector<Finding> findings_of(const std::vector<DriveReport>& drives);

/// Logged velocity over d(position)/dt outside of 1/kPlainFactor...kPlainFactor is another unit or
/// another filter, if the two otherwise agree to kAgreement.
constexpr double kPlainFactor = 1.2;
constexpr double kAgreement = 0.8;

/// Speeds beyond this many times the no-load speed are not those of this actuator.
constexpr double kImplausibleSpeed = 3.0;

/// Nobody knows what a leg did in a longer step: it can have made a stance of its own.
constexpr double kMostUnseen_s = 0.1;

std::optional<Finding> gap_finding(const LongestStep& step);

/// Longer than both, so that slopes across it are no motion's.
bool hides_motion(const LongestStep& step);

/// Why rates, such as "accelerations", cannot be had across it, and what can be done.
/// --from and --until are in the file's own clock.
std::string hidden_motion_sentence(const LongestStep& step, double clock_origin_s,
                                   std::string_view rates);

/// That the velocity of a joint is not the rate of its position, from where to where, why perhaps,
/// and what can be done. Times are in the file's own clock.
std::string contradiction_sentence(const std::string& joint,
                                   const TravelContradiction& contradiction, double clock_origin_s,
                                   const VelocityAgreement& agreement);

}  // namespace torquewright::actuator
