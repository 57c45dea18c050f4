// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::identification {

/// The values at which a channel stands again and again, stiller than anywhere beside: the ends of
/// what it can show. One, two or none. docs/logs.md has the rule with its numbers.
std::vector<double> find_saturated_values(const std::vector<double>& values);

}  // namespace torquewright::identification
