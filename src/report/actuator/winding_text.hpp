// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/winding/winding_estimate.hpp"

namespace torquewright::report {

/// A table of the four, with what it rests on.
std::string winding_text(const actuator::WindingEstimate& estimate);

}  // namespace torquewright::report
