// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/mor/region_comparison.hpp"

namespace torquewright::report {

/// Two regions side by side: figures, and per quadrant the worst loss and the best gain of torque.
std::string comparison_text(const std::string& from, const std::string& to,
                            const actuator::RegionComparison& comparison);

}  // namespace torquewright::report
