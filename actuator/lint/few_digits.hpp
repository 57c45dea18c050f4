// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// Returns notes on constants whose decimals leave more open than catalogues do, so that nothing
/// contradicts them: 1 Nm/A stands for 0.5 to 1.5 where 1.0 may have been printed. Assumed values
/// are left out.
std::vector<Finding> few_digits(const Actuator& document);

}  // namespace torquewright::actuator::lint
