// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::identification {

/// Returns the values at which a channel is saturated: it stays at them again and again, longer
/// than at any value beside. One, two or none. docs/logs.md has the rule with its numbers.
std::vector<double> find_saturated_values(const std::vector<double>& values);

}  // namespace torquewright::identification
