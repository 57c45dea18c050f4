// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/check/report.hpp"

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

/// A step of more than this many others' length is said: integrals and slopes run straight across.
constexpr double kGap = 20.0;

std::optional<Finding> gap_finding(const LongestStep& step);

}  // namespace torquewright::actuator
