// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::identification {

/// What a channel was `delay_s` before each time, straight between its samples; before the first it
/// was as at the first. Times ascend.
std::vector<double> delayed(const std::vector<double>& time_s, const std::vector<double>& values,
                            double delay_s);

}  // namespace torquewright::identification
