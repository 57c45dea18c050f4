// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "actuator/lint/examination.hpp"

namespace torquewright::actuator::lint {

/// A motor of round numbers that states nothing twice: Kt 0.125, R 0.25, 24 V, 10:1, 40 A.
Actuator sample();

/// As read from specs/actuator.
Actuator from_specs(const char* file);

/// Of one rule in one document; empty where it does not apply, or found nothing.
std::optional<Comparison> comparison(const Actuator& document, std::string_view rule);
std::optional<Finding> finding(const Examination& examination, std::string_view rule);
std::optional<Finding> finding(const Actuator& document, std::string_view rule);

/// The explanation with that sentence; fails the test and returns an empty one if there is none.
Explanation explanation(const Finding& finding, std::string_view sentence);

}  // namespace torquewright::actuator::lint
