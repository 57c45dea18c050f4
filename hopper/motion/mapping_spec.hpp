// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/trajectory/columns.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper {

/// Returns the mappings of a document of kind `trajectory_columns`, as stated. Whether owners,
/// quantities and units exist is checked with the robot.
std::vector<actuator::MappingText> read_mappings(const io::Document& document);

}  // namespace torquewright::hopper
