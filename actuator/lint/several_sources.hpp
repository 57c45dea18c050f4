// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// A note of each number that several sources state differently (the document's "also").
std::vector<Finding> several_sources(const Actuator& document);

}  // namespace torquewright::actuator::lint
